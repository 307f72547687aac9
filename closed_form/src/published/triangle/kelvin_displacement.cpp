// SPDX-License-Identifier: MIT
#include "published/triangle/kelvin_displacement.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted kelvin_displacement_forms{
    "triangle.kelvin_displacement",
    {{Misprint::None, "[T24] Eq 49, after the errata"},
     {Misprint::AppendixA, "[T24] with the sign of omega_t that Appendix A states"},
     {Misprint::Equation48, "[T24] with Eq 48 read literally"}},
    []<Scalar R>(const Frame<R>& f, int, std::span<const R> parameters, Misprint misprint) {
      return kelvin_displacement<R>(f, parameters[0], parameters[1], misprint);
    },
    0};

}  // namespace
}  // namespace cageproof::closed_form::published
