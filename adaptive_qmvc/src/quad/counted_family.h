// SPDX-License-Identifier: MIT
// Registers evaluations of quads whose name ends in a count.
#pragma once

#include "cageproof/core/catalogue/counted_name.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/unknown_name.h"

namespace cageproof::adaptive_qmvc {

/// The number n of `<stem>-<n><suffix>`, 1 ... 512; nothing for other names.
inline std::optional<int> count_in(const std::string& stem, std::string_view suffix, std::string_view name) {
  if (!name.ends_with(suffix)) return std::nullopt;
  const auto n = number_after(stem + "-", name.substr(0, name.size() - suffix.size()));
  return n && *n <= 512 ? n : std::nullopt;
}

/// The family `<stem>-<n><suffix>`, n = 1 ... 512. `studied`: EvaluationFamily::studied. `weights` is a callable with
/// `template operator()<R>(batch, n, output)`, for derivatives up to `max_order`.
template <class Weights>
EvaluationFamily counted_family(const std::string& formula, const std::string& stem, std::vector<std::string> standard,
                                std::vector<std::string> studied, const std::string& description, Weights weights,
                                int max_order = 0, const std::string& suffix = "") {
  const auto make = [=](std::string_view name) -> std::optional<Evaluation> {
    const auto n = count_in(stem, suffix, name);
    if (!n) return std::nullopt;
    Evaluation made(
        formula, name,
        {.description = description, .role = Role::Scheme, .cost = CostClass::Nodes, .max_order = max_order});
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        made.set_batch<R>([weights, n = *n](const Batch<R>& batch, const BatchOutput<R>& output) {
          weights.template operator()<R>(batch, n, output);
        });
      });
    return made;
  };
  const std::string pattern = stem + "-<n>" + suffix;
  state_range(pattern, "n from 1 to 512");
  return {formula, pattern, Role::Scheme, std::move(standard), make, {}, std::move(studied)};
}

}  // namespace cageproof::adaptive_qmvc
