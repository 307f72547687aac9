// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/biharmonic_double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return biharmonic_double_layer<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{published_family("triangle.biharmonic_double_layer", Misprint::None,
                                                    "[T24] Eq 15-18, Appendix C, after the errata", form)};
const RegisterEvaluation eq18{
    published_family("triangle.biharmonic_double_layer", Misprint::Equation18, "[T24] with Eq 18 as printed", form)};
const RegisterEvaluation appendix_c{published_family("triangle.biharmonic_double_layer", Misprint::AppendixC,
                                                     "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
