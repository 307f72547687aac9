// SPDX-License-Identifier: MIT
// An evaluation: one way to compute one formula, generic over the scalar; and the register of all of them.
#pragma once

#include "cageproof/core/formula.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace cageproof {

/// The input of an evaluation.
template <Scalar R>
struct Query {
  std::span<const Vec3<R>> corners;  ///< the element's corners, corner_count(element) of them
  Vec3<R> point = Vec3<R>::Zero();   ///< eta
  int order = 0;                     ///< highest derivative wanted: 0 value, 1 gradient, 2 Hessian
  std::span<const R> parameters{};   ///< in the order of Formula::parameters
  /// On an element's border, where a value diverges like the distance's logarithm: leave that term out. Cages need it, in whose sums the
  /// terms of neighbours cancel. Evaluations without it give no finite value there.
  bool finite_part = false;
};

/// The output of an evaluation: tensors with respect to the point, the last index the fastest.
template <Scalar R>
struct Result {
  std::vector<R> value;     ///< [component]
  std::vector<R> gradient;  ///< [component][i], empty when order < 1
  std::vector<R> hessian;   ///< [component][i][j], empty when order < 2
  /// Radii about the entries of each tensor within which the formula's value is proven to lie, infinite where nothing
  /// is; empty when the evaluation proves nothing.
  std::vector<R> value_radius, gradient_radius, hessian_radius;
  /// Decimal digits, relative and norm-wise, that the evaluation itself stands behind for the worst tensor asked for;
  /// NaN where it makes no statement (closed forms, fixed rules).
  double stated_digits = std::numeric_limits<double>::quiet_NaN();
  /// False where an evaluation with a tolerance (adaptive, multiprecision) could not meet it.
  bool converged = true;
  std::size_t nodes = 0;  ///< kernel evaluations spent; 0 for closed forms

  /// Sizes the arrays for `components` tensors in `dim` dimensions up to `order` and sets them to zero.
  void reset(int components, int dim, int order) {
    value.assign(components, R(0));
    gradient.assign(order >= 1 ? components * dim : 0, R(0));
    hessian.assign(order >= 2 ? components * dim * dim : 0, R(0));
    for (int o = 0; o < 3; ++o) radius_of(o).clear();
    stated_digits = std::numeric_limits<double>::quiet_NaN();
    converged = true;
    nodes = 0;
  }
  /// The tensor of derivative order 0, 1 or 2.
  const std::vector<R>& of(int order) const { return order == 0 ? value : order == 1 ? gradient : hessian; }
  std::vector<R>& of(int order) { return order == 0 ? value : order == 1 ? gradient : hessian; }
  /// The radii of derivative order 0, 1 or 2.
  const std::vector<R>& radius_of(int order) const {
    return order == 0 ? value_radius : order == 1 ? gradient_radius : hessian_radius;
  }
  std::vector<R>& radius_of(int order) {
    return order == 0 ? value_radius : order == 1 ? gradient_radius : hessian_radius;
  }
};

/// One way to compute one formula.
class Evaluation {
 public:
  template <Scalar R>
  using Function = std::function<void(const Query<R>&, Result<R>&)>;

  Evaluation() = default;
  Evaluation(std::string formula, std::string name, std::string description, int max_order = 2)
      : formula_(std::move(formula)), name_(std::move(name)), description_(std::move(description)),
        max_order_(max_order) {}

  const std::string& formula() const { return formula_; }
  const std::string& name() const { return name_; }
  const std::string& description() const { return description_; }
  int max_order() const { return max_order_; }  ///< highest derivative it gives
  /// Whether it states how many digits it stands behind (Result::stated_digits).
  bool states_error() const { return states_error_; }
  void set_states_error() { states_error_ = true; }
  /// Evaluations of the formula that stand in for this one in multiprecision because they stop at fewer digits: `truths` at 34 or more, `confirmations` at some
  /// more, so that other nodes are taken where the digits decide them, `yardsticks` at 12 or more. Empty: this one is quick enough itself.
  struct Substitutes {
    std::string truths, confirmations, yardsticks;
  };
  const Substitutes& substitutes() const { return substitutes_; }
  void set_substitutes(Substitutes names) { substitutes_ = std::move(names); }

  template <Scalar R>
  void set(Function<R> f) { std::get<Function<R>>(functions_) = std::move(f); }
  template <Scalar R>
  bool supports() const { return static_cast<bool>(std::get<Function<R>>(functions_)); }
  bool supports(ScalarKind kind) const {
    return with_scalar(kind, [&]<Scalar R>() { return supports<R>(); });
  }
  /// \pre supports<R>() and query.order <= max_order(); throws std::bad_function_call otherwise.
  template <Scalar R>
  void operator()(const Query<R>& query, Result<R>& result) const { std::get<Function<R>>(functions_)(query, result); }

 private:
  std::string formula_, name_, description_;
  int max_order_ = 2;
  bool states_error_ = false;
  Substitutes substitutes_;
  std::tuple<Function<float>, Function<double>, Function<Mp50>, Function<Mp100>, Function<Mp200>> functions_;
};

/// Evaluations that share one way of computing, for one formula: `closed_form`, or all `gauss-N`.
struct EvaluationFamily {
  std::string formula;
  std::string pattern;                ///< "closed_form", "gauss-<N>": what `list` shows
  /// The members that verification runs and `list` names; none where a check alone asks for the one member, which is
  /// named as the pattern.
  std::vector<std::string> standard;
  /// The member of that name, or nothing when the name is not of this family.
  std::function<std::optional<Evaluation>(std::string_view name)> make;
};

/// The evaluations of all rooms linked into the program. Rooms add theirs when the program starts.
class EvaluationRegister {
 public:
  static EvaluationRegister& instance();
  void add(EvaluationFamily family);
  /// The families of a formula, sorted by pattern.
  std::vector<const EvaluationFamily*> families(std::string_view formula) const;
  /// The evaluation of that name, or nothing.
  std::optional<Evaluation> find(std::string_view formula, std::string_view name) const;
  /// The standard members of all families of a formula, `closed_form` first, then by name.
  std::vector<std::string> standard(std::string_view formula) const;

 private:
  std::vector<EvaluationFamily> families_;
};

/// Adds a family at program start: `const RegisterEvaluation r{...};` at namespace scope of the evaluation's .cpp.
struct RegisterEvaluation {
  explicit RegisterEvaluation(EvaluationFamily family) { EvaluationRegister::instance().add(std::move(family)); }
};

}  // namespace cageproof
