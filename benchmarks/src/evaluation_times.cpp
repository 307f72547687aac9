// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/evaluation_times.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "pair_times.h"

namespace cageproof::benchmarks {
namespace {

constexpr std::uint64_t seed = 1;
// An adaptive rule takes as long as some hundred evaluations of fixed cost.
constexpr std::size_t few_pairs = 5, many_pairs = 32;

std::vector<validation::Sample> generic_samples(const Formula& formula) {
  const validation::Regime& generic = *validation::find_regime("generic");
  std::vector<validation::Sample> samples;
  for (std::size_t i = 0; i < many_pairs; ++i) samples.push_back(make_sample(formula, generic, seed, i));
  return samples;
}

EvaluationTime time_of(const Evaluation& evaluation, int order, const std::vector<validation::Sample>& samples) {
  const std::size_t count = evaluation.cost() == CostClass::Adaptive ? few_pairs : many_pairs;
  TimedPairs pairs{.samples = {samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count)},
                   .evaluations = {}};
  pairs.evaluations.assign(count, {&evaluation});
  WorkPrecisionRow row;
  time_pairs(pairs, order, 0, row);
  return {std::string(evaluation.formula().name), evaluation.name(), order, row.median_nanoseconds};
}

}  // namespace

std::vector<EvaluationTime> times_of_evaluations(const std::string& formulas, const std::string& evaluations) {
  std::vector<EvaluationTime> times;
  for (const Formula& formula : catalogue()) {
    if (!matches(formulas, formula.name)) continue;
    const std::vector<validation::Sample> samples = generic_samples(formula);
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name)) {
      const Evaluation evaluation = *EvaluationRegister::instance().find(formula.name, name);
      if (!evaluation.supports<double>() || evaluation.cost() == CostClass::Multiprecision ||
          !validation::matches_evaluation(evaluations, evaluation))
        continue;
      for (int order = 0; order <= std::min(2, evaluation.max_order()); ++order)
        times.push_back(time_of(evaluation, order, samples));
    }
  }
  return times;
}

}  // namespace cageproof::benchmarks
