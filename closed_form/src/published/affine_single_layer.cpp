// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/affine_single_layer.h"

#include "register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Setting<R>& s, const Query<R>& q, Misprint misprint) {
  return affine_single_layer<R>(s, q.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.affine_single_layer", Misprint::None, "[T24] Eq 43-46, after the errata", form)};
const RegisterEvaluation eq18{
    published_family("triangle.affine_single_layer", Misprint::Equation18, "[T24] with Eq 18 as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
