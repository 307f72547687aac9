// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/green.h"

#include "register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Setting<R>& s, const Query<R>& q, Misprint misprint) {
  return single_layer<R>(s, q.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.single_layer", Misprint::None, "Urago's form, [T24] Appendix C after the errata", form)};
const RegisterEvaluation appendix_c{
    published_family("triangle.single_layer", Misprint::AppendixC, "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
