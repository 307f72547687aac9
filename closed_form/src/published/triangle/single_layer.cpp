// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return single_layer<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.single_layer", Misprint::None, "Urago's form, [T24] Appendix C after the errata", form)};
const RegisterEvaluation appendix_c{
    published_family("triangle.single_layer", Misprint::AppendixC, "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
