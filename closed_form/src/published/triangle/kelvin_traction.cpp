// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/kelvin_traction.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return kelvin_traction<R>(f, batch.parameters[0], batch.parameters[1], misprint);
};
const RegisterEvaluation published{
    published_family("triangle.kelvin_traction", Misprint::None, "[T24] Eq 49, after the errata", form, 0)};
const RegisterEvaluation eq18{
    published_family("triangle.kelvin_traction", Misprint::Equation18, "[T24] with Eq 18 as printed", form, 0)};
const RegisterEvaluation eq48{
    published_family("triangle.kelvin_traction", Misprint::Equation48, "[T24] with Eq 48 read literally", form, 0)};
const RegisterEvaluation eq49{
    published_family("triangle.kelvin_traction", Misprint::Equation49, "[T24] with Eq 49 as printed", form, 0)};

}  // namespace
}  // namespace cageproof::closed_form::published
