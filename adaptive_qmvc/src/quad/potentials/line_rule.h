// SPDX-License-Identifier: MIT
// How many digits the line form has of its own, and the family `line-<digits>` of a formula.
#pragma once

#include "cageproof/core/catalogue/counted_name.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <functional>
#include <optional>
#include <string>

namespace cageproof::adaptive_qmvc {

/// The digits of the integral: a little more than a double holds, and in multiprecision enough for the differences that
/// yardsticks and checks take of it.
template <Scalar R>
constexpr double own_digits() {
  return std::same_as<R, Mp50> ? 36 : std::same_as<R, Mp100> ? 48 : std::same_as<R, Mp200> ? 90 : 17;
}

/// The line form to as many digits as the name says, 2 to 90. \param set sets an evaluation's functions for that many
inline EvaluationFamily line_rule(std::string_view formula, const std::string& description,
                                  const std::function<void(Evaluation&, std::optional<double>)>& set) {
  const auto make = [formula, description, set](std::string_view name) -> std::optional<Evaluation> {
    const auto digits = number_after("line-", name);
    if (!digits || *digits < 2 || *digits > 90) return std::nullopt;
    Evaluation made(formula, name, {.description = description, .role = Role::Rule, .cost = CostClass::Direct});
    set(made, *digits);
    return made;
  };
  return {std::string(formula), "line-<digits>", Role::Rule, {"line-12"}, make, {}, {"line-12"}};
}

}  // namespace cageproof::adaptive_qmvc
