// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/work_precision.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/truth.h"
#include "asked_evaluations.h"
#include "pair_times.h"
#include "point_times.h"
#include "summarise.h"
#include "whole_work_precision.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

// The evaluations of a kind's formulas on each kind of element that the cage has: of that name, or the recommended one
// where only quads have it.
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

// Pairs of a group's points and elements, of which the first few are spread over all of them, too.
TimedPairs pairs_of(const CageElements& elements, const KindEvaluations& evaluations, const PointGroup& group,
                    const std::vector<double>& parameters, std::size_t most) {
  const std::size_t all = group.points.size() * elements.count(), count = std::min(all, most);
  std::size_t stride = static_cast<std::size_t>(0.618 * static_cast<double>(all)) | 1;
  while (std::gcd(stride, all) != 1) ++stride;
  TimedPairs work;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t pair = n * stride % all, element = pair % elements.count();
    work.samples.push_back({elements.corners(element), group.points[pair / elements.count()].point, parameters, 0, 0});
    work.evaluations.push_back(evaluations.on(elements.type(element).kind));
  }
  return work;
}

// Vectors of points are full, and a call's own cost is small in comparison.
constexpr std::size_t kBatch = 1024;

// Measures the time per pair of a point and an element, on one thread, for many points at once.
void time_at_once(const CageCoordinates& coordinates, const std::vector<CagePoint>& group, double seconds,
                  WorkPrecisionRow& row) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<Vec3<double>> points;
  points.reserve(std::max(kBatch, group.size()));
  while (points.size() < kBatch)
    for (const CagePoint& p : group) points.push_back(p.point);
  const std::size_t pairs = points.size() * coordinates.elements().count();
  std::vector<double> each = nanoseconds_of_batches(coordinates, points, seconds);
  for (double& nanoseconds : each) nanoseconds /= static_cast<double>(pairs);
  summarise_times(std::move(each), row);
  row.timed *= pairs;
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

// The samples that errors are measured at, and as many more of the place as are to be timed; no more where there is no
// time for them.
std::vector<Sample> timed_samples(const Formula& formula, const RegimePlace& place, std::vector<Sample> samples,
                                  const WorkPrecisionOptions& options) {
  const std::size_t count = options.seconds > 0 ? options.timed : std::min(samples.size(), least_timed_pairs);
  samples.resize(std::min(samples.size(), count));
  samples.reserve(count);
  while (samples.size() < count) {
    samples.push_back(make_sample(formula, *place.regime, options.seed, place.first + samples.size() * place.stride));
    if (!options.parameters.empty()) samples.back().parameters = options.parameters;
  }
  return samples;
}

}  // namespace

WorkPrecision cage_work_precision(const Cage& cage, const CoordinateKind& kind, const std::vector<PointGroup>& groups,
                                  const WorkPrecisionOptions& given) {
  if (!exists_on(kind, cage))
    throw InputError(fmt::format("{}: {} coordinates do not exist on cages of this dimension", cage.name(), kind.name));
  if (!kind.is_sum()) return whole_work_precision(cage, kind, groups, given);
  WorkPrecisionOptions options = given;
  std::vector<std::string> notes;
  const Subject subject{kind.name, leading_formulas(kind, cage), whole_evaluation_names(kind, cage)};
  options.evaluations = evaluations_asked(given.evaluations, subject, options.order, notes);
  const auto evaluations = find_all(subject, options);
  std::vector<double> parameters = options.parameters;
  if (parameters.empty())
    for (const Parameter& p : parameters_of(kind)) parameters.push_back(p.preset);
  WorkPrecision result = empty_measurement(kind.name, options);
  result.notes = std::move(notes);
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
      set_place(group, row);
      const CageCoordinates coordinates(cage, kind, row.evaluation, options.triangulation, parameters);
      std::vector<double> errors(group.points.size());
      for_each_parallel(errors.size(), options.jobs, [&](std::size_t i) {
        const CagePoint& p = group.points[i];
        errors[i] = errors_at(coordinates, cage, p.point, expected_sum(kind, p.place), 0).partition[0].relative;
      });
      summarise(std::move(errors), row);
      if (subject.has_whole(row.evaluation)) {
        time_at_once(coordinates, group.points, options.seconds, row);
        result.rows.push_back(std::move(row));
        continue;
      }
      const KindEvaluations timed(kind, cage, row.evaluation);
      time_pairs(pairs_of(coordinates.elements(), timed, group, parameters, static_cast<std::size_t>(options.timed)), 0,
                 options.seconds, row);
      result.rows.push_back(std::move(row));
    }
  }
  if (result.rows.empty()) throw InputError(fmt::format("{}: no point to measure at", cage.name()));
  return result;
}

WorkPrecision formula_work_precision(const Formula& formula, const std::vector<const Regime*>& regimes,
                                     const WorkPrecisionOptions& given) {
  WorkPrecisionOptions options = given;
  std::vector<std::string> notes;
  const Subject subject{formula.name, {formula.name}, {}};
  options.evaluations = evaluations_asked(given.evaluations, subject, options.order, notes);
  const auto evaluations = find_all(subject, options);
  const TruthSource source = truth_source(formula);
  WorkPrecision result = empty_measurement(formula.name, options);
  result.notes = std::move(notes);
  result.where = "one element";
  result.error = "relative error";
  result.unit = "1";
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
    TimedPairs timed{.samples = timed_samples(formula, place, samples, options), .evaluations = {}};
    for (const auto& one : evaluations) {
      WorkPrecisionRow row;
      row.evaluation = one.front().name();
      row.place = place.name;
      row.distance = place.distance;
      if (place.distance > 0) {
        row.sweep = place.regime->name;
        row.axis = place.regime->parameter_name;
      }
      std::vector<double> errors;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!truths[i].exists[options.order]) continue;
        const Result<double> found = evaluate<double>(one.front(), samples[i], options.order);
        errors.push_back(relative_error(found, truths[i], options.order));
        if (options.relative) continue;
        const double units = conditioned_error(found, truths[i], options.order, u);
        row.units = std::max(row.units.value_or(0), std::isfinite(units) ? units : HUGE_VAL);
      }
      summarise(std::move(errors), row);
      timed.evaluations.assign(timed.samples.size(), {&one.front()});
      time_pairs(timed, options.order, options.seconds, row);
      result.rows.push_back(std::move(row));
    }
  }
  if (result.rows.empty()) throw InputError(fmt::format("{}: no sample has a truth to measure against", formula.name));
  return result;
}

std::vector<std::string> default_work_precision_evaluations(const std::vector<std::string_view>& formulas, int order) {
  std::vector<std::string> notes;
  return evaluations_asked({}, {formulas.back(), formulas, {}}, order, notes);
}

}  // namespace cageproof::benchmarks
