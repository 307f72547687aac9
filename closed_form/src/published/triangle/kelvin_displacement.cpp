// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/kelvin_displacement.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return kelvin_displacement<R>(f, batch.parameters[0], batch.parameters[1], misprint);
};
const RegisterEvaluation published{
    published_family("triangle.kelvin_displacement", Misprint::None, "[T24] Eq 49, after the errata", form, 0)};
const RegisterEvaluation appendix_a{published_family("triangle.kelvin_displacement", Misprint::AppendixA,
                                                     "[T24] with the sign of omega_t that Appendix A states", form, 0)};
const RegisterEvaluation eq48{
    published_family("triangle.kelvin_displacement", Misprint::Equation48, "[T24] with Eq 48 read literally", form, 0)};

}  // namespace
}  // namespace cageproof::closed_form::published
