// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/affine_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return affine_single_layer<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.affine_single_layer", Misprint::None, "[T24] Eq 43-46, after the errata", form)};
const RegisterEvaluation eq18{
    published_family("triangle.affine_single_layer", Misprint::Equation18, "[T24] with Eq 18 as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
