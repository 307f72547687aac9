// SPDX-License-Identifier: MIT
// An evaluation: one way to compute one formula, generic over the scalar; and the register of all of them.
#pragma once

#include "cageproof/core/catalogue/batch.h"
#include "cageproof/core/catalogue/role.h"

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace cageproof {

/// The facts that an evaluation states about itself.
struct EvaluationFacts {
  std::string description;
  Role role = Role::Rule;
  CostClass cost = CostClass::Nodes;
  bool states_error = false;  ///< whether it states how many digits it stands behind (Statement::digits)
  int max_order = 2;          ///< highest derivative it gives
  /// Evaluations of the formula that stand in for this one in multiprecision because they stop at fewer digits:
  /// `truths` at 34 or more, `confirmations` at more digits, hence with other nodes, and `yardsticks` at 12 or more.
  /// Empty: this one is quick enough itself.
  struct Substitutes {
    std::string truths, confirmations, yardsticks;
  } substitutes = {};
};

/// A formula among others that are computed at once on one element, and share what they have in common there (the
/// element as the point sees it, moments). Formulas of one type share.
template <Scalar R>
class JointForm {
 public:
  virtual ~JointForm() = default;
  /// Computes members for a block of points, one output each. \pre this is one of them, and all are of its type
  virtual void together(std::span<const JointForm* const> members, const Batch<R>& batch,
                        std::span<const BatchOutput<R>> outputs) const = 0;
};

/// How an evaluation computes in one scalar; at least one of `batch` and `point` is set where it does. Thread-safe,
/// without memory of earlier calls.
template <Scalar R>
struct EvaluationFunctions {
  /// Computes a block of points of one element.
  std::function<void(const Batch<R>&, const BatchOutput<R>&)> batch;
  /// Computes one point, with Result's radii where the evaluation proves any.
  std::function<void(const Query<R>&, Result<R>&)> point;
  std::shared_ptr<const JointForm<R>> joint = {};  ///< null where it shares nothing
};

/// One way to compute one formula.
class Evaluation {
 public:
  Evaluation() = default;
  Evaluation(std::string_view formula, std::string_view name, EvaluationFacts facts);

  const Formula& formula() const { return *formula_; }
  const std::string& name() const { return name_; }
  const EvaluationFacts& facts() const { return *facts_; }
  const std::string& description() const { return facts_->description; }
  Role role() const { return facts_->role; }
  CostClass cost() const { return facts_->cost; }
  int max_order() const { return facts_->max_order; }
  bool states_error() const { return facts_->states_error; }
  const EvaluationFacts::Substitutes& substitutes() const { return facts_->substitutes; }

  template <Scalar R>
  void set_batch(std::function<void(const Batch<R>&, const BatchOutput<R>&)> f) {
    of<R>().batch = std::move(f);
  }
  template <Scalar R>
  void set_point(std::function<void(const Query<R>&, Result<R>&)> f) {
    of<R>().point = std::move(f);
  }
  template <Scalar R>
  void set_joint(std::shared_ptr<const JointForm<R>> form) {
    of<R>().joint = std::move(form);
  }

  template <Scalar R>
  bool supports() const {
    return of<R>().batch || of<R>().point;
  }
  bool supports(ScalarKind kind) const {
    return with_scalar(kind, [&]<Scalar R>() { return supports<R>(); });
  }
  /// One point. \pre supports<R>() and query.order <= max_order()
  template <Scalar R>
  void operator()(const Query<R>& query, Result<R>& result) const;
  /// A block of points. \pre as above
  template <Scalar R>
  void operator()(const Batch<R>& batch, const BatchOutput<R>& output) const;
  /// Several formulas on one element; shares work where the evaluations can. \pre as above, one output each
  template <Scalar R>
  static void together(std::span<const Evaluation* const> members, const Batch<R>& batch,
                       std::span<const BatchOutput<R>> outputs);

 private:
  template <Scalar R>
  const EvaluationFunctions<R>& of() const {
    return std::get<EvaluationFunctions<R>>(functions_);
  }
  template <Scalar R>
  EvaluationFunctions<R>& of() {
    return std::get<EvaluationFunctions<R>>(functions_);
  }

  const Formula* formula_ = nullptr;
  std::string name_;
  std::shared_ptr<const EvaluationFacts> facts_;
  std::tuple<EvaluationFunctions<float>, EvaluationFunctions<double>, EvaluationFunctions<Mp50>,
             EvaluationFunctions<Mp100>, EvaluationFunctions<Mp200>>
      functions_;
};

/// Evaluations that share one way of computing, for one formula: `closed_form`, or all `gauss-N`.
struct EvaluationFamily {
  std::string formula;
  std::string pattern;  ///< "closed_form", "gauss-<N>": what `list` shows
  Role role = Role::Rule;
  /// The members that verification runs and `list` names. Empty where only a check asks for the single member, which
  /// then has the pattern's name.
  std::vector<std::string> standard;
  /// The member of that name, or nothing when the name is not of this family.
  std::function<std::optional<Evaluation>(std::string_view name)> make;
  /// Another name that people and stored cases may use for the pattern; empty for none.
  std::string alias = {};
  /// The members that work-precision studies show, coarse to fine; empty for none.
  std::vector<std::string> studied = {};

  /// A member that stands for all: the first standard one, or the one of the pattern's name.
  Evaluation example() const { return make(standard.empty() ? pattern : standard.front()).value(); }
};

/// All evaluations that are linked into the program; each adds itself when the program starts. Families stay where they
/// are.
class EvaluationRegister {
 public:
  static EvaluationRegister& instance();
  void add(EvaluationFamily family);
  /// The families of a formula: the recommended one first, then by pattern.
  std::vector<const EvaluationFamily*> families(std::string_view formula) const;
  /// The evaluation of that name or alias, or nothing.
  std::optional<Evaluation> find(std::string_view formula, std::string_view name) const;
  /// The formula's evaluation of that role: the first standard member of the first family with the role that has any,
  /// else the member of the pattern's name of the first with the role; nothing where no family has it.
  std::optional<Evaluation> with_role(std::string_view formula, Role role) const;
  /// The standard members of all families of a formula, the recommended one first, then by name.
  std::vector<std::string> standard(std::string_view formula) const;

 private:
  std::list<EvaluationFamily> families_;
};

/// Adds a family at program start: `const RegisterEvaluation r{...};` at namespace scope of the evaluation's .cpp.
struct RegisterEvaluation {
  explicit RegisterEvaluation(EvaluationFamily family) { EvaluationRegister::instance().add(std::move(family)); }
};

/// The family of one evaluation that has the pattern for its name.
/// \param fill sets its functions
EvaluationFamily single_family(std::string_view formula, std::string_view name, EvaluationFacts facts, bool standard,
                               std::function<void(Evaluation&)> fill);

/// The evaluation of that name. \throws InputError naming formula and evaluation where there is none
Evaluation evaluation_named(std::string_view formula, std::string_view name);

/// The formula of that name. \throws InputError where there is none
const Formula& formula_named(std::string_view name);

}  // namespace cageproof
