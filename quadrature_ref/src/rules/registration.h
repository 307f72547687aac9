// SPDX-License-Identifier: MIT
// What the registrations of rules share: names of members, and evaluations made of a rule and a kernel.
#pragma once

#include "cageproof/quadrature_ref/kernel.h"

#include <charconv>
#include <stdexcept>

namespace cageproof::quadrature_ref {

/// The number after `prefix` in `name`, written without sign or leading zeros.
inline std::optional<int> number_after(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  const std::string_view digits = name.substr(prefix.size());
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.starts_with('0') || number < 1)
    return std::nullopt;
  return number;
}

/// `rule.template operator()<R>(integrand, query, result)` for every scalar. Keeps the kernels alive.
template <class Rule>
Evaluation evaluation(const std::string& formula, std::string_view name, std::string description,
                      const std::shared_ptr<const KernelSet>& kernels, Rule rule) {
  // The catalogue is looked up here, not at registration: it may not exist yet while the program starts.
  const Formula* found = find_formula(formula);
  if (!found) throw std::logic_error("kernel without a row in the catalogue: " + formula);
  const Formula& row = *found;
  Evaluation result(formula, std::string(name), std::move(description));
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      result.set<R>([&row, kernels, rule](const Query<R>& query, Result<R>& tensors) {
        rule.template operator()<R>(Integrand{row, *kernels}, query, tensors);
      });
    });
  return result;
}

}  // namespace cageproof::quadrature_ref
