// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/kelvin_traction.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto kelvin_traction_form = []<Scalar R>(const Frame<R>& f, int, std::span<const R> parameters,
                                               Misprint misprint) {
  return kelvin_traction<R>(f, parameters[0], parameters[1], misprint);
};
const RegisterEvaluation kelvin_traction_published{published_family(
    "triangle.kelvin_traction", Misprint::None, "[T24] Eq 49, after the errata", kelvin_traction_form, 0)};
const RegisterEvaluation kelvin_traction_eq18{published_family("triangle.kelvin_traction", Misprint::Equation18,
                                                               "[T24] with Eq 18 as printed", kelvin_traction_form, 0)};
const RegisterEvaluation kelvin_traction_eq48{published_family(
    "triangle.kelvin_traction", Misprint::Equation48, "[T24] with Eq 48 read literally", kelvin_traction_form, 0)};
const RegisterEvaluation kelvin_traction_eq49{published_family("triangle.kelvin_traction", Misprint::Equation49,
                                                               "[T24] with Eq 49 as printed", kelvin_traction_form, 0)};

}  // namespace
}  // namespace cageproof::closed_form::published
