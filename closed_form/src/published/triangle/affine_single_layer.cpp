// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/affine_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto affine_single_layer_form = []<Scalar R>(const Frame<R>& f, int order, std::span<const R>,
                                                   Misprint misprint) {
  return affine_single_layer<R>(f, order, misprint);
};
const RegisterEvaluation affine_single_layer_published{published_family(
    "triangle.affine_single_layer", Misprint::None, "[T24] Eq 43-46, after the errata", affine_single_layer_form)};
const RegisterEvaluation affine_single_layer_eq18{published_family(
    "triangle.affine_single_layer", Misprint::Equation18, "[T24] with Eq 18 as printed", affine_single_layer_form)};

}  // namespace
}  // namespace cageproof::closed_form::published
