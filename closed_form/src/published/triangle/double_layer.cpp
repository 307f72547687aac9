// SPDX-License-Identifier: MIT
#include "published/triangle/double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPrinted double_layer_forms{
    "triangle.double_layer",
    {{Misprint::None, "Urago's form, [T24] Appendix C after the errata"},
     {Misprint::AppendixC, "[T24] with Appendix C as printed"}},
    []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
      return double_layer<R>(f, order, misprint);
    }};

const RegisterEvaluation double_layer_curl{printed_family(
    "triangle.double_layer", "curl-form", "P x d/(2|t|) for the gradient: right only for closed cages' sums", false,
    Misprint::None, []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint) {
      return double_layer_curl_form(f, order);
    })};

}  // namespace
}  // namespace cageproof::closed_form::published
