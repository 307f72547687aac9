// SPDX-License-Identifier: MIT
// The role of an evaluation, and its cost: callers ask for these instead of a name.
#pragma once

#include <array>
#include <string_view>

namespace cageproof {

/// The purpose of an evaluation.
enum class Role {
  Recommended,  ///< the one to use, at most one per formula
  ClosedForm,   ///< algebra kept to a promise by more digits; in multiprecision it may stand in for the integral
  Plain,        ///< the closed form in the scalar's own arithmetic: its errors are shown, not promised away
  Stated,       ///< full digits by a bound of its own error that it states
  Rule,         ///< quadrature: of fixed size, or to a tolerance
  Integral,     ///< the defining integral in multiprecision: the truth
  Enclosure,    ///< balls proven to contain the integral
  Printed,      ///< what a paper prints, after or before its errata
  Scheme,       ///< a paper's or a baseline's way of approximating, with an error of its own
  Batched,      ///< whole cages at once
  Foreign,      ///< somebody else's code
};

inline constexpr std::array roles{Role::Recommended, Role::ClosedForm, Role::Plain,     Role::Stated,
                                  Role::Rule,        Role::Integral,   Role::Enclosure, Role::Printed,
                                  Role::Scheme,      Role::Batched,    Role::Foreign};

/// "recommended", "stated" ...
constexpr std::string_view name_of(Role role) {
  constexpr std::array<std::string_view, roles.size()> names{"recommended", "closed form", "plain",     "stated",
                                                             "rule",        "integral",    "enclosure", "printed",
                                                             "scheme",      "batched",     "foreign"};
  return names[static_cast<std::size_t>(role)];
}

/// The cost of one pair of element and point, by order of magnitude; campaigns take fewer samples of costly ones.
enum class CostClass {
  Direct,          ///< microseconds, whatever the input
  Nodes,           ///< a fixed number of kernel evaluations
  Adaptive,        ///< as many as the input demands
  Multiprecision,  ///< milliseconds to seconds
};

/// "direct", "nodes", "adaptive", "multiprecision".
constexpr std::string_view name_of(CostClass cost) {
  constexpr std::array<std::string_view, 4> names{"direct", "nodes", "adaptive", "multiprecision"};
  return names[static_cast<std::size_t>(cost)];
}

}  // namespace cageproof
