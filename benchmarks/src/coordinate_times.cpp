// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/coordinate_times.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "point_times.h"
#include "summarise.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <cmath>
#include <utility>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

double difference(const std::vector<double>& found, const std::vector<Mp50>& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double d = std::abs(static_cast<double>(Mp50(Mp50(found[i]) - truth[i])));
    worst = std::isfinite(d) ? std::max(worst, d) : HUGE_VAL;
  }
  return worst;
}

// Mean nodes of a sum's formulas on one element, at some of the points; 0 for kinds that are no sums.
double mean_nodes(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points) {
  const CoordinateKind& kind = coordinates.kind();
  if (!kind.is_sum()) return 0;
  const CageElements& elements = coordinates.elements();
  double nodes = 0, pairs = 0;
  Result<double> result;
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (const SummedBlock& block : kind.blocks) {
      const Formula* formula = find_formula(elements.type(e).kind, block.kernel);
      auto evaluation = EvaluationRegister::instance().find(formula->name, coordinates.evaluation());
      if (!evaluation) evaluation = EvaluationRegister::instance().with_role(formula->name, Role::Recommended);
      std::vector<double> parameters;
      parameters.reserve(formula->parameters.size());
      for (const Parameter& p : formula->parameters) parameters.push_back(p.preset);
      const auto corners = elements.corners(e);
      const Vec3<double>& point = points[e * points.size() / elements.count()];
      (*evaluation)(Query<double>{corners, point, 0, parameters}, result);
      nodes += static_cast<double>(result.nodes);
      ++pairs;
    }
  return nodes / pairs;
}

// Mean value coordinates of the triangulated cage as printed: the first column of [T18] Table 1, which the paper's
// other times are compared with.
bool is_first_column(const WorkPrecisionRow& row) {
  const auto evaluation = EvaluationRegister::instance().find("triangle.mean_value", row.evaluation);
  return row.place == "mean_value" && evaluation && evaluation->role() == Role::Printed;
}

// A note per row: how many times its median time is the first column's.
void add_ratios(WorkPrecision& result) {
  const auto first = std::ranges::find_if(result.rows, is_first_column);
  if (first == result.rows.end()) return;
  for (const WorkPrecisionRow& row : result.rows)
    result.notes.push_back(fmt::format("{}, {}: {:.2g} times as long as {}, {}", row.place, row.evaluation,
                                       row.median_nanoseconds / first->median_nanoseconds, first->place,
                                       first->evaluation));
}

// The first column of [T18] Table 1, with which the paper compares its times: mean value coordinates of the
// triangulated cage, as printed.
class FirstColumn {
 public:
  FirstColumn(const Cage& cage, const std::vector<Vec3<double>>& points, Triangulation rule)
      : points_(points),
        coordinates_(cage, coordinate_kind_named("mean_value"),
                     EvaluationRegister::instance().with_role("triangle.mean_value", Role::Printed)->name(), rule) {}

  std::string evaluation() const { return std::string(coordinates_.evaluation()); }
  // Times of points, in nanoseconds, are added to those of earlier calls.
  void time(double& sink) {
    const auto more = nanoseconds_of_points(coordinates_, points_, 0.1, points_.size(), sink);
    found_.insert(found_.end(), more.begin(), more.end());
  }
  // The median, after which it starts anew.
  double median() {
    WorkPrecisionRow row;
    summarise_times(std::exchange(found_, {}), row);
    return row.median_nanoseconds;
  }

 private:
  const std::vector<Vec3<double>>& points_;
  CageCoordinates coordinates_;
  std::vector<double> found_;
};

}  // namespace

std::vector<KindAndEvaluation> table_one() {
  // The schemes as verification runs them, and the rule that costs what a closed form does: the line form to fewer
  // digits.
  std::vector<KindAndEvaluation> what{{"mean_value", ""}};
  std::string quick;
  for (const Role role : {Role::Scheme, Role::Rule})
    for (const EvaluationFamily* family : EvaluationRegister::instance().families("quad.mean_value")) {
      if (family->role != role || family->standard.empty() ||
          (role == Role::Rule && family->example().cost() != CostClass::Direct))
        continue;
      for (const std::string& name : family->standard) what.push_back({"quad_mean_value", name});
      if (role == Role::Rule) quick = family->standard.front();
    }
  what.insert(what.end(), {{"quad_mean_value", ""}, {"spherical_mean_value", ""}, {"maximum_entropy", quick}});
  for (const EvaluationFamily* family : EvaluationRegister::instance().families("triangle.mean_value"))
    if (family->role == Role::Printed)
      for (const std::string& name : family->standard) what.push_back({"mean_value", name});
  return what;
}

WorkPrecision coordinate_times(const Cage& cage, const std::vector<Vec3<double>>& points,
                               const std::vector<KindAndEvaluation>& what, const WorkPrecisionOptions& options) {
  if (points.empty()) throw InputError(fmt::format("{}: no point to compute coordinates at", cage.name()));
  WorkPrecision result;
  result.subject = "whole coordinates";
  result.where = fmt::format("{}, {} points", cage.name(), points.size());
  result.error = "difference from quad mean value coordinates";
  result.unit = "1";
  result.timed = "point";
  result.seed = options.seed;
  const CageCoordinates reference(cage, coordinate_kind_named("quad_mean_value"),
                                  CoordinateOptions{.triangulation = options.triangulation});
  const std::size_t count = std::min<std::size_t>(options.samples, points.size());
  std::vector<Vec3<double>> compared;
  for (std::size_t i = 0; i < count; ++i) compared.push_back(points[i * points.size() / count]);
  std::vector<std::vector<Mp50>> truth(count);
  for_each_parallel(count, options.jobs,
                    [&](std::size_t i) { truth[i] = reference.at<Mp50>(convert<Mp50>(compared[i]), 0).front().value; });
  double sink = 0;
  // The paper's table is of cages in space.
  std::optional<FirstColumn> first;
  if (cage.dimension() == 3) first.emplace(cage, points, options.triangulation);
  for (const auto& [kind, evaluation] : what) {
    const CageCoordinates coordinates(cage, coordinate_kind_named(kind), evaluation, options.triangulation);
    WorkPrecisionRow row;
    row.place = kind;
    row.evaluation = coordinates.evaluation();
    row.nodes = mean_nodes(coordinates, points);
    std::vector<double> errors(count);
    for_each_parallel(count, options.jobs, [&](std::size_t i) {
      errors[i] = difference(coordinates.at<double>(compared[i], 0).front().value, truth[i]);
    });
    summarise(std::move(errors), row);
    // Before and after, so that what else the machine does slows both sides.
    if (first) first->time(sink);
    summarise_times(nanoseconds_of_points(coordinates, points, std::max(1.0, options.seconds), points.size(), sink),
                    row);
    if (first) first->time(sink);
    if (first)
      result.notes.push_back(fmt::format("{}, {}: {:.0f} ms for the mesh, {:.2g} times as long as mean_value, {}", kind,
                                         row.evaluation, row.nanoseconds * static_cast<double>(points.size()) / 1e6,
                                         row.median_nanoseconds / first->median(), first->evaluation()));
    result.rows.push_back(std::move(row));
  }
  add_ratios(result);
  // A result must be used, or the compiler may leave out its computation.
  if (std::isnan(sink)) result.notes.emplace_back("some points have no coordinates");
  return result;
}

}  // namespace cageproof::benchmarks
