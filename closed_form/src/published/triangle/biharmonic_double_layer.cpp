// SPDX-License-Identifier: MIT
#include "published/triangle/biharmonic_double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted biharmonic_double_layer_forms{
    "triangle.biharmonic_double_layer",
    {{Misprint::None, "[T24] Eq 15-18, Appendix C, after the errata"},
     {Misprint::Equation18, "[T24] with Eq 18 as printed"},
     {Misprint::AppendixC, "[T24] with Appendix C as printed"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return biharmonic_double_layer<R>(f, order, misprint);
    }};

}  // namespace
}  // namespace cageproof::closed_form::published
