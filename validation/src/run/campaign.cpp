// SPDX-License-Identifier: MIT
#include "campaign.h"

#include "checks/element_questions.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// A question of a job, and the samples that it is asked at.
struct Part {
  ElementQuestion question;
  int nth, end;  // takes every nth sample of those below end
};

// A formula in a regime, and all that is asked of it there.
struct Plan {
  const Formula* formula;
  const Regime* regime;
  std::optional<TruthSource> source;  // none where nothing is asked
  std::vector<Part> parts;
};

// Whether an evaluation is one that people rely on, and quick enough to be asked at every sample: no rule or scheme,
// whose errors are known to be large, and nothing adaptive.
bool takes_every_sample(const Evaluation& evaluation) {
  const Role role = evaluation.role();
  return role != Role::Rule && role != Role::Scheme && evaluation.cost() < CostClass::Adaptive;
}

// Stride of costly checks. Seven is prime to every sweep's length, so that all decades are visited. The second sample
// is in the middle of distances down to 1e-16, and at the end of those up to 1e8, so sweeps have two integrals or more.
constexpr int wide_stride = 7;

// Largest odd stride up to n, at least one: samples exactly on an element and a rounding off it take turns.
constexpr int largest_odd(int n) { return n < 2 ? 1 : n - (n % 2 == 0 ? 1 : 0); }

// The samples of a regime that are taken: every stride-th below end.
struct TakenSamples {
  int end, stride;
};

// Where truths are costly, a quarter; then whatever else is measured against them costs little. But at least five,
// since fewer leave checks without a point next to the element, and of a sweep that a quarter would leave off in the
// middle some of its whole length.
TakenSamples samples_of(const CampaignOptions& options, const Regime& regime, const TruthSource& source) {
  const int values = static_cast<int>(regime.parameters.size());
  const int samples = std::max(options.samples, std::min(values, options.swept_samples));
  if (!source.is_costly()) return {samples, 1};
  if (samples < 4 * values) return {samples, wide_stride};
  return {std::max(std::min(samples, 5), (samples + 3) / 4), 1};
}

// The highest order that a check asks, where truths are costly. On an element such integrals extrapolate from several
// distances, which takes a minute of a matrix's Hessians; next to one they take seconds, and `generic` asks.
int order_for(const Check& check, const Evaluation& evaluation, ScalarKind scalar, const Regime& regime,
              const CampaignOptions& options, const TruthSource& source) {
  int order = std::min(2, evaluation.max_order());
  const bool on_element = regime.name.starts_with("on-");
  if (check.cost(scalar) != Check::Cost::Multiprecision || !source.is_costly()) return order;
  if (!on_element && regime.parameters.empty()) return order;
  const std::size_t most = on_element ? options.integral_entries : 9 * options.integral_entries;
  const Formula& formula = evaluation.formula();
  const auto entries = [&](int o) {
    return static_cast<std::size_t>(formula.components()) * derivative_count(formula.dim(), o);
  };
  while (most > 0 && order > 0 && entries(order) > most) --order;
  return order;
}

// The question of a check in a regime and the samples that it takes; nothing where it is not asked.
std::optional<Part> part_for(const Check& check, const Evaluation& evaluation, ScalarKind scalar, const Regime& regime,
                             const CampaignOptions& options, const TruthSource& source) {
  auto question = element_question(check, evaluation, scalar, regime.name,
                                   order_for(check, evaluation, scalar, regime, options, source));
  if (!question) return std::nullopt;
  const auto [samples, stride] = samples_of(options, regime, source);
  const auto every = [&](int nth, int end) { return Part{std::move(*question), nth, end}; };
  switch (check.cost(scalar)) {
    case Check::Cost::Enclosure: return every(wide_stride, wide_stride * options.enclosures);
    case Check::Cost::Multiprecision: {
      // One, where few samples of a sweep are taken: integrals next to costly elements take seconds.
      if (stride > 1) return every(stride, 1);
      // Half of them where nothing is swept. Points on an element lie exactly on it and a rounding off it by turns, and
      // only the latter have all derivatives: one of each at least, or no derivative would be confirmed.
      const bool none_swept = regime.parameters.empty();
      const int half = std::max(std::min(2, options.integral_samples), (options.integral_samples + 1) / 2);
      const int integrals = none_swept ? half : options.integral_samples;
      const int nth = none_swept ? std::min(wide_stride, largest_odd(samples - 1)) : wide_stride;
      return every(nth, std::min(samples, nth * integrals));
    }
    case Check::Cost::Truths: return every(wide_stride, samples);
    case Check::Cost::Evaluations: break;
  }
  // Samples rounded to float have truths of their own: the first and the last of a sweep, and elsewhere one exactly on
  // the element and one off it.
  constexpr int costly_stride = 3;
  const bool few = scalar == ScalarKind::Float;
  if (source.is_costly()) return every(!few ? stride : stride == 1 ? costly_stride : 2 * stride, samples);
  const bool all = takes_every_sample(evaluation) && scalar != ScalarKind::Float;
  return every(all ? 1 : options.quadrature_divisor, samples);
}

Plan plan_for(const Formula& formula, const Regime& regime, const CampaignOptions& options) {
  Plan plan{&formula, &regime, {}, {}};
  auto& evaluations = EvaluationRegister::instance();
  if (!has_truth_source(formula) || !exists_for(regime, formula.element)) return plan;
  plan.source = truth_source(formula);
  for (const auto& check : checks())
    for (const std::string& name : evaluations.standard(formula.name)) {
      // The gate is asked for whatever else is: without it there is no truth.
      const Evaluation evaluation = *evaluations.find(formula.name, name);
      if (!matches_evaluation(options.evaluations, evaluation) && check->use() != Check::Use::Gate) continue;
      for (const ScalarKind scalar : scalar_kinds)
        if (auto part = part_for(*check, evaluation, scalar, regime, options, *plan.source))
          plan.parts.push_back(std::move(*part));
    }
  return plan;
}

// A formula in a regime; sample i of all its parts is made, and its truth found, once.
class ElementMeasurement final : public Measurement {
 public:
  ElementMeasurement(Plan plan, std::uint64_t seed) : plan_(std::move(plan)), seed_(seed) {
    for (const Part& part : plan_.parts) end_ = std::max(end_, part.end);
    // Costly checks take only the first samples; smaller blocks would leave all of these to one thread.
    constexpr int least = 16;
    block_size_ = std::max(least, ((end_ + most_blocks - 1) / most_blocks + least - 1) / least * least);
  }
  std::string name() const override { return fmt::format("{}, {}", plan_.formula->name, plan_.regime->name); }
  int blocks() const override { return std::max(1, (end_ + block_size_ - 1) / block_size_); }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const Part& part : plan_.parts) add_rows_of(part.question, rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    PartialResult gathered;
    for (int i = block * block_size_; i < std::min(end_, (block + 1) * block_size_); ++i)
      measure_sample(i, gathered.rows);
    return gathered;
  }

 private:
  static bool takes(const Part& part, int i) { return i % part.nth == 0 && i < part.end; }

  void measure_sample(int i, std::map<RowKey, Tally>& rows) const {
    if (std::ranges::none_of(plan_.parts, [&](const Part& part) { return takes(part, i); })) return;
    const Sample exact = make_sample(*plan_.formula, *plan_.regime, seed_, i);
    for (const bool single : {false, true}) {
      const ElementAt at(*plan_.source, single ? rounded_to(ScalarKind::Float, exact) : exact);
      for (const Part& part : plan_.parts) {
        if ((part.question.scalar == ScalarKind::Float) != single || !takes(part, i)) continue;
        const bool has_curve = part.question.check->use() == Check::Use::Truth;
        record(part.question, at, rows, has_curve ? plan_.regime->parameters.size() : 0);
      }
    }
  }

  Plan plan_;
  std::uint64_t seed_;
  int end_ = 0, block_size_ = 0;
};

template <class Range, class Name>
auto matching(const Range& range, const std::string& pattern, std::string_view what, Name name) {
  std::vector<const std::ranges::range_value_t<Range>*> found;
  for (const auto& item : range)
    if (matches(pattern, name(item))) found.push_back(&item);
  if (found.empty()) throw InputError(fmt::format("no {} matches '{}'; see `cageproof list`", what, pattern));
  return found;
}

}  // namespace

Measurements element_measurements(const CampaignOptions& options) {
  Measurements measurements;
  bool any_part = false;
  const auto name_of_row = [](const auto& row) { return row.name; };
  for (const Formula* formula : matching(catalogue(), options.formulas, "formula", name_of_row))
    for (const Regime* regime : matching(regimes(), options.regimes, "regime", name_of_row)) {
      Plan plan = plan_for(*formula, *regime, options);
      for (const Part& part : plan.parts)
        any_part = any_part || matches_evaluation(options.evaluations, part.question.evaluation);
      if (plan.parts.empty()) continue;
      measurements.push_back(std::make_unique<ElementMeasurement>(std::move(plan), options.seed));
    }
  if (!any_part) throw InputError(fmt::format("no evaluation matches '{}'; see `cageproof list`", options.evaluations));
  return measurements;
}

std::vector<std::string> notes_on_truth(const std::string& formulas) {
  std::vector<std::string> notes;
  for (const Formula& formula : catalogue())
    if (matches(formulas, formula.name) && has_truth_source(formula) && truth_source(formula).is_integral())
      notes.push_back(fmt::format(
          "{}: no recommended evaluation; the truth is the integral in 100 digits, confirmed to 30 by the one in 50",
          formula.name));
  return notes;
}

Judged run_campaign(const CampaignOptions& options) {
  Judged found = judged(measure_all(element_measurements(options), options.jobs, options.progress).rows);
  for (std::string& note : notes_on_truth(options.formulas)) found.notes.push_back(std::move(note));
  return found;
}

}  // namespace cageproof::validation
