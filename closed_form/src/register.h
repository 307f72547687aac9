// SPDX-License-Identifier: MIT
// Turns a closed form over triangles into an entry of the register.
#pragma once

#include "cageproof/closed_form/jet.h"

namespace cageproof::closed_form {

/// `form` is a callable with `template operator()<R>(triangle, query) -> Jet<R, C>`, for every scalar, up to `max_order`.
template <class Form>
EvaluationFamily triangle_family(std::string formula, std::string name, std::string description, Form form,
                                 int max_order = 2) {
  const auto make = [formula, name, description, form, max_order](std::string_view asked) -> std::optional<Evaluation> {
    if (asked != name) return std::nullopt;
    Evaluation evaluation(formula, name, description, max_order);
    const auto set = [&]<Scalar R>() {
      evaluation.set<R>([form](const Query<R>& query, Result<R>& result) {
        const Triangle<R> t{query.corners[0], query.corners[1], query.corners[2]};
        store(form.template operator()<R>(t, query), query.order, result);
      });
    };
    for (const ScalarKind kind : scalar_kinds) with_scalar(kind, [&]<Scalar R>() { set.template operator()<R>(); });
    return evaluation;
  };
  return {formula, name, {name}, make};
}

}  // namespace cageproof::closed_form
