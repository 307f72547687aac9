// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/green.h"

#include "register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Setting<R>& s, const Query<R>& q, Misprint misprint) {
  return double_layer<R>(s, q.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.double_layer", Misprint::None, "Urago's form, [T24] Appendix C after the errata", form)};
const RegisterEvaluation appendix_c{
    published_family("triangle.double_layer", Misprint::AppendixC, "[T24] with Appendix C as printed", form)};

EvaluationFamily curl_family() {
  EvaluationFamily family = triangle_family(
      "triangle.double_layer", "curl-form", "P x d/(2|t|) for the gradient: right for closed cages' sums alone",
      []<Scalar R>(const Triangle<R>& t, const Query<R>& q) {
        return double_layer_curl_form(Setting<R>(t, q.point), q.order);
      });
  family.standard.clear();
  return family;
}
const RegisterEvaluation curl_form{curl_family()};

}  // namespace
}  // namespace cageproof::closed_form::published
