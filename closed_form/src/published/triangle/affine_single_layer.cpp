// SPDX-License-Identifier: MIT
#include "published/triangle/affine_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted affine_single_layer_forms{
    "triangle.affine_single_layer",
    {{Misprint::None, "[T24] Eq 43-46, after the errata"}, {Misprint::Equation18, "[T24] with Eq 18 as printed"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return affine_single_layer<R>(f, order, misprint);
    }};

}  // namespace
}  // namespace cageproof::closed_form::published
