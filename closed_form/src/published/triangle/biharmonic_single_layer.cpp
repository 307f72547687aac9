// SPDX-License-Identifier: MIT
#include "published/triangle/biharmonic_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted biharmonic_single_layer_forms{
    "triangle.biharmonic_single_layer",
    {{Misprint::None, "[T24] Eq 9-14, Appendix C, after the errata"},
     {Misprint::AppendixA, "[T24] with the sign of omega_t that Appendix A states"},
     {Misprint::AppendixC, "[T24] with Appendix C as printed"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return biharmonic_single_layer<R>(f, order, misprint);
    }};

}  // namespace
}  // namespace cageproof::closed_form::published
