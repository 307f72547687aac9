// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/biharmonic_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto biharmonic_single_layer_form = []<Scalar R>(const Frame<R>& f, int order, std::span<const R>,
                                                       Misprint misprint) {
  return biharmonic_single_layer<R>(f, order, misprint);
};
const RegisterEvaluation biharmonic_single_layer_published{
    published_family("triangle.biharmonic_single_layer", Misprint::None, "[T24] Eq 9-14, Appendix C, after the errata",
                     biharmonic_single_layer_form)};
const RegisterEvaluation biharmonic_single_layer_appendix_a{
    published_family("triangle.biharmonic_single_layer", Misprint::AppendixA,
                     "[T24] with the sign of omega_t that Appendix A states", biharmonic_single_layer_form)};
const RegisterEvaluation biharmonic_single_layer_appendix_c{
    published_family("triangle.biharmonic_single_layer", Misprint::AppendixC, "[T24] with Appendix C as printed",
                     biharmonic_single_layer_form)};

}  // namespace
}  // namespace cageproof::closed_form::published
