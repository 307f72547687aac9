// SPDX-License-Identifier: MIT
#include "cageproof/validation/campaign.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cageproof::validation {
namespace {

// What one (evaluation, scalar, check, order) has found so far; merging does not depend on order.
struct Tally {
  ErrorHistogram errors;
  WorstCases worst;
  std::uint64_t without_truth = 0, declined = 0;
  double max_relative = 0;
  std::vector<double> by_parameter;

  void merge(const Tally& other) {
    errors.merge(other.errors);
    worst.merge(other.worst);
    without_truth += other.without_truth;
    declined += other.declined;
    max_relative = std::max(max_relative, other.max_relative);
    by_parameter.resize(std::max(by_parameter.size(), other.by_parameter.size()), -1);
    for (std::size_t i = 0; i < other.by_parameter.size(); ++i)
      by_parameter[i] = std::max(by_parameter[i], other.by_parameter[i]);
  }
};

// One check of one evaluation in one scalar: a job's smallest part.
struct Part {
  const Check* check;
  Evaluation evaluation;
  ScalarKind scalar;
  int divisor;  // takes every divisor-th sample
  int end;      // of those below
};

// A formula in a regime, and all that is asked of it there.
struct Plan {
  const Formula* formula;
  const Regime* regime;
  Evaluation reference;  // the closed form, in multiprecision
  std::vector<Part> parts;
};

using Tallies = std::vector<std::array<Tally, 3>>;  // by part, then order

bool is_quadrature(const Evaluation& evaluation) { return evaluation.name() != "closed_form"; }

// Steps through all decades of a sweep, whose lengths seven does not divide.
constexpr int wide_stride = 7;

// Where truths are integrals themselves, a quarter of the samples; then whatever else is measured against them costs little.
CampaignOptions affordable(CampaignOptions options, const Evaluation& reference) {
  if (reference.substitutes().truths.empty()) return options;
  options.samples = (options.samples + 3) / 4;
  options.quadrature_divisor = 1;
  return options;
}

// The samples that a check takes: every divisor-th below end.
Part part_for(const Check& check, const Evaluation& evaluation, ScalarKind scalar, const CampaignOptions& options) {
  const auto strided = [&](int divisor, int end) { return Part{&check, evaluation, scalar, divisor, end}; };
  switch (check.cost(scalar)) {
    case Check::Cost::Enclosure: return strided(wide_stride, wide_stride * options.enclosures);
    case Check::Cost::Multiprecision:
      return strided(wide_stride, std::min(options.samples, wide_stride * options.integral_samples));
    case Check::Cost::Truths: return strided(std::max(wide_stride, options.quadrature_divisor), options.samples);
    case Check::Cost::Evaluations: break;
  }
  const bool every = !is_quadrature(evaluation) && scalar != ScalarKind::Float;
  return strided(every ? 1 : options.quadrature_divisor, options.samples);
}

Plan plan_for(const Formula& formula, const Regime& regime, const CampaignOptions& options) {
  Plan plan{&formula, &regime, {}, {}};
  auto& evaluations = EvaluationRegister::instance();
  plan.reference = *evaluations.find(formula.name, "closed_form");
  for (const auto& check : checks())
    for (const std::string& name : evaluations.standard(formula.name)) {
      // The gate is asked for whatever else is: without it there is no truth.
      if (!matches(options.evaluations, name) && check->role() != Check::Role::Gate) continue;
      const Evaluation evaluation = *evaluations.find(formula.name, name);
      for (const ScalarKind scalar : scalar_kinds) {
        if (!evaluation.supports(scalar) || !check->applies(formula, evaluation, scalar, regime.name)) continue;
        plan.parts.push_back(part_for(*check, evaluation, scalar, affordable(options, plan.reference)));
      }
    }
  return plan;
}

void record(const Part& part, const Plan& plan, const Sample& sample, const std::array<Finding, 3>& findings,
            std::array<Tally, 3>& tallies) {
  for (int o = 0; o < 3; ++o) {
    const Finding& finding = findings[o];
    Tally& tally = tallies[o];
    switch (finding.status) {
      case Finding::Status::Unasked: continue;
      case Finding::Status::NoTruth: ++tally.without_truth; continue;
      case Finding::Status::Declined: ++tally.declined; continue;
      case Finding::Status::Measured: break;
    }
    tally.errors.add(finding.error);
    tally.max_relative = std::max(tally.max_relative, finding.relative);
    if (tally.worst.wants(finding.error, sample.index))
      tally.worst.add({finding.error, sample.parameter, sample.index, sample.corners, sample.point, sample.parameters});
    const std::size_t decades = plan.regime->parameters.size();
    if (decades == 0 || part.check->role() != Check::Role::Truth) continue;
    tally.by_parameter.resize(decades, -1);
    double& largest = tally.by_parameter[sample.index % decades];
    largest = std::max(largest, finding.error);
  }
}

constexpr int block_size = 16;

// Samples [first, first + block_size) of a plan, in one scalar's rounding.
void run_block(const Plan& plan, const CampaignOptions& options, int first, Tallies& tallies) {
  const auto takes = [](const Part& part, int i) { return i % part.divisor == 0 && i < part.end; };
  for (int i = first; i < first + block_size; ++i) {
    if (std::ranges::none_of(plan.parts, [&](const Part& part) { return takes(part, i); })) continue;
    const Sample exact = make_sample(*plan.formula, *plan.regime, options.seed, i);
    for (const bool single : {false, true}) {
      std::optional<Truth> truth;
      const Sample sample = single ? rounded_to(ScalarKind::Float, exact) : exact;
      for (std::size_t p = 0; p < plan.parts.size(); ++p) {
        const Part& part = plan.parts[p];
        if ((part.scalar == ScalarKind::Float) != single || !takes(part, i)) continue;
        if (!truth) truth = truth_from(plan.reference, sample, 2);
        const int order = std::min(2, part.evaluation.max_order());
        record(part, plan, sample,
               part.check->measure({*plan.formula, part.evaluation, part.scalar, sample, order, *truth}), tallies[p]);
      }
    }
  }
}

void add_results(const Plan& plan, const Tallies& tallies, CampaignResult& result) {
  for (std::size_t p = 0; p < plan.parts.size(); ++p) {
    const Part& part = plan.parts[p];
    for (int o = 0; o < 3; ++o) {
      const Tally& tally = tallies[p][o];
      if (tally.errors.count() + tally.without_truth + tally.declined == 0) continue;
      ResultRow row;
      row.subject = plan.formula->name;
      row.evaluation = part.evaluation.name();
      row.scalar = name_of(part.scalar);
      row.regime = plan.regime->name;
      row.check = part.check->name();
      row.order = o;
      row.unit = part.check->unit();
      row.samples = tally.errors.count();
      row.nonfinite = tally.errors.nonfinite();
      row.without_truth = tally.without_truth;
      row.declined = tally.declined;
      row.max = tally.errors.max();
      row.p999 = tally.errors.p999();
      row.median = tally.errors.median();
      row.max_relative = tally.max_relative;
      row.worst = tally.worst.cases();
      row.histogram.assign(tally.errors.counts().begin(), tally.errors.counts().end());
      judge(row);
      if (!tally.by_parameter.empty()) {
        ResultCurve curve{row.subject, row.evaluation, row.scalar, row.regime, row.check, o,
                          std::string(plan.regime->parameter_name), {}, {}};
        for (std::size_t i = 0; i < tally.by_parameter.size(); ++i)
          if (tally.by_parameter[i] >= 0) {
            curve.parameters.push_back(plan.regime->parameters[i]);
            curve.errors.push_back(tally.by_parameter[i]);
          }
        result.curves.push_back(std::move(curve));
      }
      result.rows.push_back(std::move(row));
    }
  }
}

bool has_role(const ResultRow& row, Check::Role role) {
  const Check* check = find_check(row.check);
  return check && check->role() == role;
}

// Where the closed form in multiprecision has not agreed with the integral, nothing that was measured against it counts.
void withdraw_unproven(CampaignResult& result) {
  const auto same_place = [](const ResultRow& a, const ResultRow& b) {
    return a.subject == b.subject && a.regime == b.regime && a.order == b.order;
  };
  for (const ResultRow& gate : result.rows) {
    if (!has_role(gate, Check::Role::Gate) || gate.verdict == Verdict::Kept) continue;
    result.notes.push_back(
        gate.samples == 0
            ? fmt::format("{}, {}, order {}: the integral confirmed the truth on none of {} samples (no limit, or fewer than "
                          "30 digits)", gate.subject, gate.regime, gate.order, gate.without_truth)
            : fmt::format("{}, {}, order {}: the closed form in multiprecision is not the integral; nothing measured against "
                          "it counts", gate.subject, gate.regime, gate.order));
    for (ResultRow& row : result.rows)
      if (!has_role(row, Check::Role::Gate) && !has_role(row, Check::Role::Proof) && same_place(row, gate)) {
        row.verdict = Verdict::NotPromised;
        row.reason = "the truth is not confirmed by the integral here";
      }
  }
}

template <class Range, class Name>
auto matching(const Range& range, const std::string& pattern, std::string_view what, Name name) {
  std::vector<const std::ranges::range_value_t<Range>*> found;
  for (const auto& item : range)
    if (matches(pattern, name(item))) found.push_back(&item);
  if (found.empty()) throw InputError(fmt::format("no {} matches '{}'; see `cageproof list`", what, pattern));
  return found;
}

}  // namespace

void judge(ResultRow& row) {
  const Promise promise =
      promise_for({row.check, row.subject, row.evaluation, row.scalar, row.regime, row.order});
  row.bound = promise.bound;
  row.reason = promise.reason;
  // A row that measured nothing keeps no promise and breaks none.
  // Off the element every limit exists: a sample without truth there is a failure of the closed form itself (in float it may have rounded
  // onto the element, or out of range).
  const bool off_element = row.section == ResultRow::Section::Element && !row.regime.starts_with("on-");
  if (row.bound && off_element && row.without_truth > 0 && has_role(row, Check::Role::Truth) && row.scalar != "float") {
    row.verdict = Verdict::Broken;
    row.reason = "the closed form in multiprecision has no value on some samples";
    return;
  }
  if (row.bound && row.samples == 0) row.reason = "no sample had a truth, or a statement, to be measured against";
  row.verdict = !row.bound || row.samples == 0 ? Verdict::NotPromised
                : row.max <= *row.bound        ? Verdict::Kept
                                               : Verdict::Broken;
}

CampaignResult run_campaign(const CampaignOptions& options) {
  std::vector<Plan> plans;
  bool any_part = false;
  const auto name_of_row = [](const auto& row) { return row.name; };
  for (const Formula* formula : matching(catalogue(), options.formulas, "formula", name_of_row))
    for (const Regime* regime : matching(regimes(), options.regimes, "regime", name_of_row)) {
      plans.push_back(plan_for(*formula, *regime, options));
      for (const Part& part : plans.back().parts)
        any_part = any_part || matches(options.evaluations, part.evaluation.name());
    }
  if (!any_part)
    throw InputError(fmt::format("no evaluation matches '{}'; see `cageproof list`", options.evaluations));

  int end = 0;
  for (const Plan& plan : plans)
    for (const Part& part : plan.parts) end = std::max(end, part.end);
  const std::size_t blocks = (end + block_size - 1) / block_size;
  std::vector<Tallies> tallies(plans.size() * blocks);
  std::atomic<std::size_t> done{0};
  for_each_parallel(tallies.size(), options.jobs, [&](std::size_t task) {
    const Plan& plan = plans[task / blocks];
    tallies[task].resize(plan.parts.size());
    run_block(plan, options, static_cast<int>(task % blocks) * block_size, tallies[task]);
    if (options.progress) options.progress(++done, tallies.size());
  });

  CampaignResult result;
  for (std::size_t p = 0; p < plans.size(); ++p) {
    Tallies merged(plans[p].parts.size());
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t part = 0; part < merged.size(); ++part)
        for (int o = 0; o < 3; ++o) merged[part][o].merge(tallies[p * blocks + b][part][o]);
    add_results(plans[p], merged, result);
  }
  withdraw_unproven(result);
  return result;
}

}  // namespace cageproof::validation
