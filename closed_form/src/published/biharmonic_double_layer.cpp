// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/biharmonic.h"

#include "register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Setting<R>& s, const Query<R>& q, Misprint misprint) {
  return biharmonic_double_layer<R>(s, q.order, misprint);
};
const RegisterEvaluation published{published_family("triangle.biharmonic_double_layer", Misprint::None,
                                                    "[T24] Eq 15-18, Appendix C, after the errata", form)};
const RegisterEvaluation eq18{
    published_family("triangle.biharmonic_double_layer", Misprint::Equation18, "[T24] with Eq 18 as printed", form)};
const RegisterEvaluation appendix_c{published_family("triangle.biharmonic_double_layer", Misprint::AppendixC,
                                                     "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
