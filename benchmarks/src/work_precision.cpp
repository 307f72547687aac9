// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/work_precision.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/parallel.h"
#include "cageproof/validation/truth.h"
#include "summarise.h"
#include "whole_work_precision.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

constexpr std::size_t timed_pairs = 64;

// What is timed: at each sample, evaluations one after the other, each with its formula's parameters.
struct Work {
  std::vector<Sample> samples;
  std::vector<std::vector<const Evaluation*>> evaluations;  // as many at each sample
};

// Sets nodes and nanoseconds: whole passes over the samples until `seconds` are over, so that each counts alike.
void time(const Work& work, int order, double seconds, WorkPrecisionRow& row) {
  using Clock = std::chrono::steady_clock;
  std::vector<QueryOf<double>> queries;
  queries.reserve(work.samples.size());
  for (const Sample& sample : work.samples) queries.emplace_back(sample, order);
  Result<double> result;
  double nodes = 0;
  const auto pass = [&] {
    nodes = 0;
    for (std::size_t i = 0; i < queries.size(); ++i)
      for (const Evaluation* evaluation : work.evaluations[i]) {
        (*evaluation)(queries[i].query(), result);
        nodes += static_cast<double>(result.nodes);
      }
  };
  // Tables that an evaluation builds at its first call are no part of its time.
  pass();
  int passes = 0;
  const auto start = Clock::now();
  double elapsed = 0;
  do {
    pass();
    ++passes;
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  } while (elapsed < seconds);
  const auto pairs = static_cast<double>(queries.size());
  row.nodes = nodes / (pairs * static_cast<double>(work.evaluations.front().size()));
  row.nanoseconds = 1e9 * elapsed / (passes * pairs);
}

// One evaluation of each formula; all that are missing in one message.
std::vector<std::vector<Evaluation>> find_all(const std::vector<std::string_view>& formulas,
                                              const WorkPrecisionOptions& options) {
  if (options.evaluations.empty()) throw InputError("no evaluation to measure");
  std::vector<std::string> missing;
  std::vector<std::vector<Evaluation>> found;
  for (const std::string& name : options.evaluations) {
    auto& row = found.emplace_back();
    for (const auto formula : formulas) {
      auto e = EvaluationRegister::instance().find(formula, name);
      if (!e) missing.push_back(fmt::format("{} has no evaluation '{}'", formula, name));
      else if (!e->supports<double>()) missing.push_back(fmt::format("'{}' of {} has no double", name, formula));
      else if (e->max_order() < options.order)
        missing.push_back(fmt::format("'{}' of {} gives no derivatives of order {}", name, formula, options.order));
      else row.push_back(std::move(*e));
    }
  }
  if (!missing.empty()) throw InputError(fmt::format("{}; see `cageproof list`", fmt::join(missing, ", ")));
  return found;
}

// The evaluations of a kind's formulas on each kind of element that the cage has: of that name, or the recommended one
// where quads alone have it.
class KindEvaluations {
 public:
  KindEvaluations(const CoordinateKind& kind, const Cage& cage, const std::string& name) {
    for (const Formula* formula : cageproof::formulas_of(kind, cage)) {
      auto found = EvaluationRegister::instance().find(formula->name, name);
      if (!found) found = EvaluationRegister::instance().with_role(formula->name, Role::Recommended);
      of_kind_[static_cast<std::size_t>(formula->element)].push_back(std::move(*found));
    }
  }
  std::vector<const Evaluation*> on(ElementKind kind) const {
    std::vector<const Evaluation*> found;
    for (const Evaluation& evaluation : of_kind_[static_cast<std::size_t>(kind)]) found.push_back(&evaluation);
    return found;
  }

 private:
  std::array<std::vector<Evaluation>, element_kinds.size()> of_kind_;
};

// Pairs of a group's points and elements, spread evenly over all of them.
Work pairs_of(const CageElements& elements, const KindEvaluations& evaluations, const PointGroup& group,
              const std::vector<double>& parameters) {
  const std::size_t all = group.points.size() * elements.count(), count = std::min(all, timed_pairs);
  Work work;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t pair = n * all / count, element = pair % elements.count();
    work.samples.push_back({elements.corners(element), group.points[pair / elements.count()].point, parameters, 0, 0});
    work.evaluations.push_back(evaluations.on(elements.type(element).kind));
  }
  return work;
}

// The formulas that must have an evaluation for a kind to be measured by it: those of quads where the kind keeps them.
std::vector<std::string_view> leading_formulas(const CoordinateKind& kind, const Cage& cage) {
  const auto all = cageproof::formulas_of(kind, cage);
  std::vector<std::string_view> leading;
  for (const Formula* formula : all)
    if (formula->element == all.back()->element) leading.push_back(formula->name);
  return leading;
}

WorkPrecision empty_measurement(std::string_view subject, const WorkPrecisionOptions& options) {
  WorkPrecision result;
  result.subject = subject;
  result.order = options.order;
  result.seed = options.seed;
  return result;
}

// Which samples of a regime are one place.
struct RegimePlace {
  const Regime* regime;
  std::string name;
  double distance;
  std::uint64_t first, stride;
};

std::vector<RegimePlace> places_of(const std::vector<const Regime*>& regimes, const WorkPrecisionOptions& options) {
  std::vector<RegimePlace> places;
  for (const Regime* regime : regimes) {
    const auto& swept = regime->parameters;
    if (!options.by_parameter || swept.empty()) {
      places.push_back({regime, std::string(regime->name), 0, 0, 1});
      continue;
    }
    for (std::size_t k = 0; k < swept.size(); ++k)
      places.push_back({regime, fmt::format("{} {:.0e}", regime->name, swept[k]), swept[k], k, swept.size()});
  }
  return places;
}

}  // namespace

WorkPrecision cage_work_precision(const Cage& cage, const CoordinateKind& kind, const std::vector<PointGroup>& groups,
                                  const WorkPrecisionOptions& given) {
  if (!exists_on(kind, cage))
    throw InputError(fmt::format("{}: {} coordinates do not exist on cages of this dimension", cage.name(), kind.name));
  if (!kind.is_sum()) return whole_work_precision(cage, kind, groups, given);
  WorkPrecisionOptions options = given;
  if (options.evaluations.empty())
    options.evaluations = default_work_precision_evaluations(leading_formulas(kind, cage), options.order);
  const auto evaluations = find_all(leading_formulas(kind, cage), options);
  std::vector<double> parameters = options.parameters;
  if (parameters.empty())
    for (const Parameter& p : parameters_of(kind)) parameters.push_back(p.preset);
  WorkPrecision result = empty_measurement(kind.name, options);
  result.where = cage.name();
  result.error = "partition of unity residual";
  result.unit = "1";
  for (const PointGroup& group : groups) {
    if (group.points.empty()) {
      result.notes.push_back(fmt::format("{}: no point found", group.place));
      continue;
    }
    for (std::size_t e = 0; e < evaluations.size(); ++e) {
      WorkPrecisionRow row;
      row.evaluation = options.evaluations[e];
      row.place = group.place;
      row.distance = group.distance;
      const CageCoordinates coordinates(cage, kind, row.evaluation, options.triangulation, parameters);
      std::vector<double> errors(group.points.size());
      for_each_parallel(errors.size(), options.jobs, [&](std::size_t i) {
        const CagePoint& p = group.points[i];
        errors[i] = errors_at(coordinates, cage, p.point, expected_sum(kind, p.place), 0).partition[0].relative;
      });
      summarise(std::move(errors), row);
      const KindEvaluations timed(kind, cage, row.evaluation);
      time(pairs_of(coordinates.elements(), timed, group, parameters), 0, options.seconds, row);
      result.rows.push_back(std::move(row));
    }
  }
  if (result.rows.empty()) throw InputError(fmt::format("{}: no point to measure at", cage.name()));
  return result;
}

WorkPrecision formula_work_precision(const Formula& formula, const std::vector<const Regime*>& regimes,
                                     const WorkPrecisionOptions& given) {
  WorkPrecisionOptions options = given;
  if (options.evaluations.empty())
    options.evaluations = default_work_precision_evaluations({formula.name}, options.order);
  const auto evaluations = find_all({formula.name}, options);
  const TruthSource source = truth_source(formula);
  WorkPrecision result = empty_measurement(formula.name, options);
  result.where = "one element";
  result.error = options.relative ? "relative error" : "conditioned error";
  result.unit = options.relative ? "1" : "u";
  const Mp100 u(unit_roundoff<double>());
  for (const RegimePlace& place : places_of(regimes, options)) {
    std::vector<Sample> samples(options.samples);
    std::vector<Truth> truths(samples.size());
    for_each_parallel(samples.size(), options.jobs, [&](std::size_t i) {
      samples[i] = make_sample(formula, *place.regime, options.seed, place.first + i * place.stride);
      if (!options.parameters.empty()) samples[i].parameters = options.parameters;
      truths[i] = truth_from(source, samples[i], options.order);
    });
    const auto known = std::ranges::count_if(truths, [&](const Truth& t) { return t.exists[options.order]; });
    if (known < std::ssize(truths))
      result.notes.push_back(fmt::format("{}: no truth at {} samples", place.name, std::ssize(truths) - known));
    if (known == 0) continue;
    for (const auto& one : evaluations) {
      WorkPrecisionRow row;
      row.evaluation = one.front().name();
      row.place = place.name;
      row.distance = place.distance;
      std::vector<double> errors;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!truths[i].exists[options.order]) continue;
        const Result<double> found = evaluate<double>(one.front(), samples[i], options.order);
        errors.push_back(options.relative ? relative_error(found, truths[i], options.order)
                                          : conditioned_error(found, truths[i], options.order, u));
      }
      summarise(std::move(errors), row);
      const std::size_t timed = std::min(samples.size(), timed_pairs);
      time({{samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(timed)}, {timed, {&one.front()}}},
           options.order, options.seconds, row);
      result.rows.push_back(std::move(row));
    }
  }
  if (result.rows.empty()) throw InputError(fmt::format("{}: no sample has a truth to measure against", formula.name));
  return result;
}

std::vector<std::string> default_work_precision_evaluations(const std::vector<std::string_view>& formulas, int order) {
  const auto& known = EvaluationRegister::instance();
  std::vector<std::string> names;
  for (const Role role : {Role::Scheme, Role::Rule, Role::Recommended, Role::Printed})
    for (const EvaluationFamily* family : known.families(formulas.back())) {
      if (family->role != role) continue;
      const bool form = role == Role::Recommended || role == Role::Printed;
      const auto& shown = form ? family->standard : family->studied;
      names.insert(names.end(), shown.begin(), shown.end());
    }
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::any_of(formulas, [&](auto formula) {
      const auto evaluation = known.find(formula, name);
      return !evaluation || evaluation->max_order() < order;
    });
  });
  return names;
}

}  // namespace cageproof::benchmarks
