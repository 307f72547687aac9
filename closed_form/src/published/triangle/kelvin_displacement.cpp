// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/kelvin_displacement.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto kelvin_displacement_form = []<Scalar R>(const Frame<R>& f, int, std::span<const R> parameters,
                                                   Misprint misprint) {
  return kelvin_displacement<R>(f, parameters[0], parameters[1], misprint);
};
const RegisterEvaluation kelvin_displacement_published{published_family(
    "triangle.kelvin_displacement", Misprint::None, "[T24] Eq 49, after the errata", kelvin_displacement_form, 0)};
const RegisterEvaluation kelvin_displacement_appendix_a{
    published_family("triangle.kelvin_displacement", Misprint::AppendixA,
                     "[T24] with the sign of omega_t that Appendix A states", kelvin_displacement_form, 0)};
const RegisterEvaluation kelvin_displacement_eq48{published_family("triangle.kelvin_displacement", Misprint::Equation48,
                                                                   "[T24] with Eq 48 read literally",
                                                                   kelvin_displacement_form, 0)};

}  // namespace
}  // namespace cageproof::closed_form::published
