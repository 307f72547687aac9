// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/biharmonic_double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto biharmonic_double_layer_form = []<Scalar R>(const Frame<R>& f, int order, std::span<const R>,
                                                       Misprint misprint) {
  return biharmonic_double_layer<R>(f, order, misprint);
};
const RegisterEvaluation biharmonic_double_layer_published{
    published_family("triangle.biharmonic_double_layer", Misprint::None, "[T24] Eq 15-18, Appendix C, after the errata",
                     biharmonic_double_layer_form)};
const RegisterEvaluation biharmonic_double_layer_eq18{
    published_family("triangle.biharmonic_double_layer", Misprint::Equation18, "[T24] with Eq 18 as printed",
                     biharmonic_double_layer_form)};
const RegisterEvaluation biharmonic_double_layer_appendix_c{
    published_family("triangle.biharmonic_double_layer", Misprint::AppendixC, "[T24] with Appendix C as printed",
                     biharmonic_double_layer_form)};

}  // namespace
}  // namespace cageproof::closed_form::published
