// SPDX-License-Identifier: MIT
#include "published/triangle/single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted single_layer_forms{
    "triangle.single_layer",
    {{Misprint::None, "Urago's form, [T24] Appendix C after the errata"},
     {Misprint::AppendixC, "[T24] with Appendix C as printed"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return single_layer<R>(f, order, misprint);
    }};

}  // namespace
}  // namespace cageproof::closed_form::published
