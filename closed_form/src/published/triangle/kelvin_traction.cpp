// SPDX-License-Identifier: MIT
#include "published/triangle/kelvin_traction.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted kelvin_traction_forms{
    "triangle.kelvin_traction",
    {{Misprint::None, "[T24] Eq 49, after the errata"},
     {Misprint::Equation18, "[T24] with Eq 18 as printed"},
     {Misprint::Equation48, "[T24] with Eq 48 read literally"},
     {Misprint::Equation49, "[T24] with Eq 49 as printed"}},
    []<Scalar R>(const Frame<R>& f, int, std::span<const R> parameters, Misprint misprint) {
      return kelvin_traction<R>(f, parameters[0], parameters[1], misprint);
    },
    0};

}  // namespace
}  // namespace cageproof::closed_form::published
