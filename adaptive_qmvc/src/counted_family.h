// SPDX-License-Identifier: MIT
// Registers evaluations of quad.mean_value whose name ends in a count.
#pragma once

#include "cageproof/core/evaluation.h"

#include <charconv>

namespace cageproof::adaptive_qmvc {

/// The family `<stem>-<n>`, n = 1 ... 512: values alone. `weights` is a callable with
/// `template operator()<R>(quad, point, n) -> 4-vector`.
template <class Weights>
EvaluationFamily counted_family(std::string stem, std::vector<std::string> standard, std::string description, Weights weights) {
  const std::string formula = "quad.mean_value";
  const auto make = [=](std::string_view name) -> std::optional<Evaluation> {
    if (!name.starts_with(stem + "-")) return std::nullopt;
    const std::string_view text = name.substr(stem.size() + 1);
    int n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    const bool whole = error == std::errc() && end == text.data() + text.size() && !text.starts_with('0');
    if (!whole || n < 1 || n > 512) return std::nullopt;
    Evaluation made(formula, std::string(name), description, 0);
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        made.set<R>([weights, n](const Query<R>& query, Result<R>& result) {
          result.reset(4, 3, 0);
          const Quad<R> q{query.corners[0], query.corners[1], query.corners[2], query.corners[3]};
          const auto w = weights.template operator()<R>(q, query.point, n);
          for (int i = 0; i < 4; ++i) result.value[i] = w[i];
        });
      });
    return made;
  };
  return {formula, stem + "-<n>", std::move(standard), make};
}

}  // namespace cageproof::adaptive_qmvc
