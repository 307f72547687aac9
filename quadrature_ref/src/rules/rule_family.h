// SPDX-License-Identifier: MIT
// The rules of each kind of element, as data. They become evaluations when a kernel is registered.
#pragma once

#include "cageproof/core/catalogue/counted_name.h"
#include "cageproof/quadrature_ref/kernel.h"

#include <functional>

namespace cageproof::quadrature_ref {

/// How a rule integrates in one scalar: blocks of points, or one point. The number is the member's (gauss-16's is 16).
template <Scalar R>
struct RuleFunctions {
  std::function<void(const Integrand&, int number, const Batch<R>&, const BatchOutput<R>&)> block;
  std::function<void(const Integrand&, int number, const Query<R>&, Result<R>&)> point;
};

/// The numbers that the names of a family's members state.
struct MemberNumbers {
  std::function<std::optional<int>(std::string_view)> number;  ///< of that name; nothing for other families' names
  std::string range = {};                                      ///< state_range
  std::optional<int> operator()(std::string_view name) const { return number(name); }
};

/// Rules that share one way of integrating, for any kernel on their element.
struct RuleFamily {
  std::string pattern;  ///< "gauss-<N>", "adaptive"
  EvaluationFacts facts;
  std::vector<std::string> standard;  ///< members that verification runs
  /// The number that a member's name states, 0 for the only member; nothing for other names.
  MemberNumbers number;
  std::vector<std::string> studied = {};  ///< EvaluationFamily::studied
  std::tuple<RuleFunctions<float>, RuleFunctions<double>, RuleFunctions<Mp50>, RuleFunctions<Mp100>,
             RuleFunctions<Mp200>>
      functions = {};

  /// Sets the functions of all scalars: `rule.template operator()<R>(integrand, number, batch, output)`.
  template <class Rule>
  RuleFamily& with_blocks(Rule rule) {
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        std::get<RuleFunctions<R>>(functions).block = [rule](const Integrand& integrand, int n, const Batch<R>& batch,
                                                             const BatchOutput<R>& output) {
          rule.template operator()<R>(integrand, n, batch, output);
        };
      });
    return *this;
  }
  /// Sets the functions of a rule that takes points one by one and has one member: `rule.template
  /// operator()<R>(integrand, query, result)`.
  template <class Rule>
  RuleFamily& with_points(Rule rule) {
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        std::get<RuleFunctions<R>>(functions).point = [rule](const Integrand& integrand, int, const Query<R>& query,
                                                             Result<R>& result) {
          rule.template operator()<R>(integrand, query, result);
        };
      });
    return *this;
  }
};

/// The number of a member called `prefix` and a number from lowest to highest.
inline MemberNumbers numbered(std::string_view prefix, int lowest, int highest) {
  return {[=](std::string_view name) -> std::optional<int> {
            const auto n = number_after(prefix, name);
            return n && lowest <= *n && *n <= highest ? n : std::nullopt;
          },
          "N from " + std::to_string(lowest) + " to " + std::to_string(highest)};
}

/// The one member of that name.
inline MemberNumbers called(std::string_view only) {
  return {[=](std::string_view name) { return name == only ? std::optional(0) : std::nullopt; }};
}

/// The facts of adaptive rules and reference integrals of all elements.
inline EvaluationFacts adaptive_facts(std::string description) {
  return {.description = std::move(description), .role = Role::Rule, .cost = CostClass::Adaptive, .states_error = true};
}
inline EvaluationFacts integral_facts() {
  return {.description = "the integral to 30 digits or more, with the digits it stands behind",
          .role = Role::Integral,
          .cost = CostClass::Multiprecision};
}
inline EvaluationFacts fixed_facts(std::string description) {
  return {.description = std::move(description), .role = Role::Rule, .cost = CostClass::Nodes};
}

namespace segment {
std::vector<RuleFamily> families();
}
namespace triangle {
std::vector<RuleFamily> families();
}
namespace quad {
std::vector<RuleFamily> families();
}

/// The families of an element's kind.
const std::vector<RuleFamily>& rules_of(ElementKind kind);

/// Adds all rules of an element's kind to the register, for the formula of that kernel on it. The catalogue's row is
/// looked up when an evaluation is asked for, so that rows may be registered later; as long as there is none, there is
/// no evaluation.
void register_rules(ElementKind kind, std::string_view kernel, const std::shared_ptr<const KernelSet>& kernels);

/// The member of a family of that name and number, for a formula and kernels that may be others than its own.
Evaluation evaluation_of(const RuleFamily& family, std::string_view name, int number, const Formula& row,
                         const std::shared_ptr<const KernelSet>& kernels);

/// The kernels that were registered for a formula; null for none.
std::shared_ptr<const KernelSet> kernels_of(std::string_view formula);

}  // namespace cageproof::quadrature_ref
