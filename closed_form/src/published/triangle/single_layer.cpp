// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto single_layer_form = []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
  return single_layer<R>(f, order, misprint);
};
const RegisterEvaluation single_layer_published{published_family(
    "triangle.single_layer", Misprint::None, "Urago's form, [T24] Appendix C after the errata", single_layer_form)};
const RegisterEvaluation single_layer_appendix_c{published_family(
    "triangle.single_layer", Misprint::AppendixC, "[T24] with Appendix C as printed", single_layer_form)};

}  // namespace
}  // namespace cageproof::closed_form::published
