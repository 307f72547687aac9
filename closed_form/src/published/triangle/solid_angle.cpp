// SPDX-License-Identifier: MIT
#include "published/triangle/solid_angle.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted solid_angle_forms{
    "triangle.solid_angle",
    {{Misprint::None, "[T24] Appendix A, Section 3.1, after the errata"},
     {Misprint::AppendixA, "[T24] with the sign of omega_t that Appendix A states"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return solid_angle<R>(f, order, misprint);
    }};

}  // namespace
}  // namespace cageproof::closed_form::published
