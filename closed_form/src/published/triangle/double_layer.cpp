// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return double_layer<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.double_layer", Misprint::None, "Urago's form, [T24] Appendix C after the errata", form)};
const RegisterEvaluation appendix_c{
    published_family("triangle.double_layer", Misprint::AppendixC, "[T24] with Appendix C as printed", form)};

const RegisterEvaluation curl_form{printed_family(
    "triangle.double_layer", "curl-form", "P x d/(2|t|) for the gradient: right for closed cages' sums alone", false,
    Misprint::None, []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint) {
      return double_layer_curl_form(f, batch.order);
    })};

}  // namespace
}  // namespace cageproof::closed_form::published
