// SPDX-License-Identifier: MIT
// Checks: what can be asked of one evaluation at one sample. Each knows the catalogue's data, and no formula.
#pragma once

#include "cageproof/validation/question.h"
#include "cageproof/validation/truth.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

namespace cageproof::validation {

/// Results of evaluations at one sample, each computed when first asked for. Evaluations are told apart by their
/// formula's name and their own. Not for several threads at once.
class ResultsAtSample {
 public:
  explicit ResultsAtSample(const Sample& sample) : sample_(sample) {}
  template <Scalar R>
  const Result<R>& of(const Evaluation& evaluation, int order) {
    auto& known = std::get<Known<R>>(known_);
    const std::tuple key(evaluation.formula().name, evaluation.name(), order);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    return known.emplace(key, evaluate<R>(evaluation, sample_, order)).first->second;
  }

 private:
  template <Scalar R>
  using Known = std::map<std::tuple<std::string_view, std::string, int>, Result<R>>;

  const Sample& sample_;
  std::tuple<Known<float>, Known<double>, Known<Mp50>, Known<Mp100>, Known<Mp200>> known_;
};

/// The input of a check.
struct CheckInput {
  const Formula& formula;
  const Evaluation& evaluation;
  ScalarKind scalar;
  const Sample& sample;
  int order;           ///< highest order to look at
  const Truth& truth;  ///< of the sample
  ResultsAtSample& results;

  /// The evaluation's result at the sample, up to the order.
  template <Scalar R>
  const Result<R>& result() const {
    return results.of<R>(evaluation, order);
  }
};

/// One check. Stateless.
class Check {
 public:
  /// How a campaign uses the findings.
  enum class Use {
    Property,
    Truth,  ///< the error that curves are drawn of
    Gate,   ///< where it is not kept, nothing measured against the truth counts
    Proof,  ///< stands on its own: counts where the gate is not kept too
  };
  /// Cost of one finding, which decides how many samples a campaign takes.
  enum class Cost {
    Evaluations,     ///< of the checked evaluation, and one truth
    Truths,          ///< several truths
    Multiprecision,  ///< evaluations in multiprecision, or an integral
    Enclosure,       ///< ball arithmetic
  };
  virtual ~Check() = default;
  virtual std::string_view name() const = 0;
  /// "conditioned" (units of u times the conditioned denominator) or "relative".
  virtual std::string_view unit() const { return "conditioned"; }
  virtual std::string_view description() const = 0;
  virtual Use use() const { return Use::Property; }
  /// That it looks at.
  virtual Orders orders() const { return {}; }
  /// In this scalar.
  virtual Cost cost(ScalarKind scalar) const {
    return scalar == ScalarKind::Float || scalar == ScalarKind::Double ? Cost::Evaluations : Cost::Multiprecision;
  }
  /// Whether to run in this combination.
  virtual bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
                       std::string_view regime) const = 0;
  virtual std::array<Finding, 3> measure(const CheckInput& input) const = 0;
};

/// All checks of single elements, in report order: `truth` first.
const std::vector<std::unique_ptr<Check>>& checks();

/// The check of that name, or null.
const Check* find_check(std::string_view name);

/// The names of all.
std::vector<std::string_view> check_names();

}  // namespace cageproof::validation
