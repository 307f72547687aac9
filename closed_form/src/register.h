// SPDX-License-Identifier: MIT
// Turns a closed form over triangles into an entry of the register.
#pragma once

#include "cageproof/closed_form/jet.h"

namespace cageproof::closed_form {

/// `form` is a callable with `template operator()<R>(triangle, eta, order) -> Jet<R, C>`.
template <class Form>
EvaluationFamily triangle_family(std::string formula, std::string description, Form form) {
  const auto make = [formula, description, form](std::string_view name) -> std::optional<Evaluation> {
    if (name != "closed_form") return std::nullopt;
    Evaluation evaluation(formula, "closed_form", description);
    const auto set = [&]<Scalar R>() {
      evaluation.set<R>([form](const Query<R>& query, Result<R>& result) {
        const Triangle<R> t{query.corners[0], query.corners[1], query.corners[2]};
        store(form.template operator()<R>(t, query.point, query.order), query.order, result);
      });
    };
    for (const ScalarKind kind : scalar_kinds) with_scalar(kind, [&]<Scalar R>() { set.template operator()<R>(); });
    return evaluation;
  };
  return {formula, "closed_form", {"closed_form"}, make};
}

}  // namespace cageproof::closed_form
