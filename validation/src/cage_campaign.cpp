// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_campaign.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/random_stream.h"
#include "cageproof/validation/cage_symmetries.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cageproof::validation {
namespace {

// One row in the making.
class RowBuilder {
 public:
  RowBuilder(std::string check, std::string unit, std::string place, int order)
      : check_(std::move(check)), unit_(std::move(unit)), place_(std::move(place)), order_(order) {}

  /// A NaN is a sample without truth.
  /// \param asked the highest derivative that the coordinates were taken with
  void add(double error, const Vec3<double>& point, std::uint64_t index, int asked = 2) {
    if (std::isnan(error)) {
      ++without_truth_;
      return;
    }
    errors_.add(error);
    if (worst_.wants(error, index)) worst_.add({error, 0, index, {}, point, {}, asked});
  }
  ResultRow row(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation) const {
    ResultRow row;
    row.section = ResultRow::Section::Cage;
    row.subject = kind.name;
    row.evaluation = evaluation;
    row.scalar = "double";
    row.regime = cage.name();
    row.check = check_;
    row.place = place_;
    row.order = order_;
    row.unit = unit_;
    row.samples = errors_.count();
    row.nonfinite = errors_.nonfinite();
    row.without_truth = without_truth_;
    row.max = row.max_relative = errors_.max();
    row.p999 = errors_.p999();
    row.median = errors_.median();
    row.worst = worst_.cases();
    row.histogram.assign(errors_.counts().begin(), errors_.counts().end());
    judge(row);
    return row;
  }

 private:
  std::string check_, unit_, place_;
  int order_;
  ErrorHistogram errors_;
  WorstCases worst_;
  std::uint64_t without_truth_ = 0;
};

// Rows by (check, place, order), in the order of the key.
using Rows = std::map<std::tuple<std::string, std::string, int>, RowBuilder>;

RowBuilder& row_of(Rows& rows, const std::string& check, const std::string& unit, std::string_view place, int order) {
  return rows.try_emplace({check, std::string(place), order}, check, unit, std::string(place), order).first->second;
}

// Kinds that the cage's quads rule out are left out; verify says so.
std::vector<const CoordinateKind*> kinds_matching(const std::string& pattern, const Cage& cage) {
  std::vector<const CoordinateKind*> found;
  for (const CoordinateKind& kind : coordinate_kinds())
    if (matches(pattern, kind.name) && accepts(kind, cage)) found.push_back(&kind);
  if (found.empty()) throw InputError(fmt::format("no kind of coordinates matches '{}' and accepts {}", pattern, cage.name()));
  return found;
}

struct PointResult {
  CageErrors errors;
  std::array<double, 3> truth{NAN, NAN, NAN};
  std::map<std::string, double> symmetries;
  std::array<double, 3> differences{NAN, NAN, NAN};
};

void add_point(Rows& rows, const CoordinateKind& kind, int order, const CagePoint& p, const PointResult& r) {
  const auto place = name_of(p.place);
  const bool outside = p.place == Place::Outside && !kind.normalised;
  for (int o = 0; o <= order; ++o) {
    const std::string unit = o == 0 ? "relative" : "of the terms";
    const std::string partition = outside ? "zero_outside" : "partition_of_unity";
    row_of(rows, partition, unit, place, o).add(r.errors.partition[o], p.point, p.index, order);
    row_of(rows, "linear_reproduction", unit, place, o).add(r.errors.reproduction[o], p.point, p.index, order);
    if (!std::isnan(r.truth[o])) row_of(rows, "cage_truth", "relative", place, o).add(r.truth[o], p.point, p.index);
  }
  for (const auto& [check, error] : r.symmetries) row_of(rows, check, "relative", place, 0).add(error, p.point, p.index);
  for (int o = 1; o < 3; ++o)
    if (!std::isnan(r.differences[o]))
      row_of(rows, "cage_differences", "relative", place, o).add(r.differences[o], p.point, p.index);
  if (!std::isnan(r.errors.laplacian))
    row_of(rows, "cage_laplacian", "of the Hessian", place, 2).add(r.errors.laplacian, p.point, p.index);
}

void add_on_cage(Rows& rows, const Cage& cage, const CageCoordinates& coordinates, const CageLocator& locator,
                 const CagePoint& p) {
  const auto place = name_of(p.place);
  // Midpoints that rounding moved off the cage prove nothing about it.
  const bool on = !coordinates.touching(p.point).empty();
  if (!coordinates.kind().normalised)
    row_of(rows, "linear_reproduction", "relative", place, 0)
        .add(on ? errors_at(coordinates, cage, p.point, 1, 0).reproduction[0] : NAN, p.point, p.index);
  row_of(rows, "limit_from_inside", "relative", place, 0)
      .add(inside_limit_error_at(coordinates, cage, locator, p.point), p.point, p.index);
}

}  // namespace

double inside_limit_error_at(const CageCoordinates& coordinates, const Cage& cage, const CageLocator& locator,
                             const Vec3<double>& point) {
  const std::vector<Touching> on = coordinates.touching(point);
  if (on.empty()) return NAN;
  Vec3<double> direction = Vec3<double>::Zero();
  for (const Touching& touch : on) direction -= coordinates.normal_at(touch);
  Vec3<double> near = point + 1e-11 * cage.size() * direction.normalized();
  // Against the mean normal lies the inside of all but saddles; there another direction does.
  for (std::uint64_t attempt = 0; !(direction.norm() > 0.1) || !locator.inside(near); ++attempt) {
    if (attempt == 1000) return NAN;
    RandomStream random(1, "inward", attempt);
    for (int c = 0; c < 3; ++c) direction[c] = random.uniform(-1, 1);
    near = point + 1e-11 * cage.size() * direction.normalized();
  }
  const auto limit = coordinates.at<double>(point, 0), inside = coordinates.at<double>(near, 0);
  if (!coordinates.kind().missing_because.empty() && std::isnan(limit[0].value[0] + inside[0].value[0])) return NAN;
  double worst = 0;
  for (std::size_t b = 0; b < limit.size(); ++b) {
    const double unit = std::pow(cage.size(), find_formula(coordinates.kind().blocks[b].formula)->degree);
    // Normalised weights have no unit.
    const double scale = coordinates.kind().normalised ? 1 : unit;
    for (std::size_t i = 0; i < limit[b].value.size(); ++i) {
      const double difference = std::abs(limit[b].value[i] - inside[b].value[i]) / scale;
      if (!(difference <= worst)) worst = std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
    }
  }
  return worst;
}

std::vector<ResultRow> run_cage_campaign(const Cage& cage, const CageCampaignOptions& options) {
  std::vector<ResultRow> all;
  for (const CoordinateKind* kind : kinds_matching(options.kinds, cage)) {
    const CageLocator locator(cage, options.triangulation, kind->keeps_quads());
    const auto off = points_off(cage, locator, options.seed, options.points);
    const CageCoordinates coordinates(cage, *kind, options.evaluation, options.triangulation);
    const auto on = options.properties_alone ? std::vector<CagePoint>{} : points_on(coordinates, cage);
    const CageCoordinates reference(cage, *kind, "closed_form", options.triangulation);
    const CageSymmetries symmetries(cage, *kind, options.evaluation, options.triangulation);
    const int order = options.properties_alone ? 0 : coordinates.max_order();
    std::vector<PointResult> results(off.size());
    // Every n-th point meets the truth, so that both ways of drawing points are seen.
    // Matrices of nine numbers in multiprecision cost as much as a quarter of the points does for single ones.
    const int truth_points = coordinates.entries(0) == 1 ? options.truth_points : (options.truth_points + 3) / 4;
    const std::size_t stride = std::max<std::size_t>(1, off.size() / std::max(1, truth_points)) | 1;
    for_each_parallel(off.size(), options.jobs, [&](std::size_t i) {
      if (off[i].place == Place::TooClose) return;
      results[i].errors = errors_at(coordinates, cage, off[i].point, expected_sum(*kind, off[i].place), order);
      if (options.properties_alone || i % stride != 0) return;
      // Coordinates that exist in double alone would meet themselves.
      if (!kind->direct) results[i].truth = truth_errors_at(coordinates, reference, off[i].point, order);
      results[i].symmetries = symmetries.errors_at(off[i].point);
      // Seven sums in 100 digits: a quarter of these points.
      if (i / stride % 4 == 0 && order == 2) results[i].differences = symmetries.differences_at(off[i].point);
    });
    Rows rows;
    for (std::size_t i = 0; i < off.size(); ++i)
      if (off[i].place != Place::TooClose) add_point(rows, *kind, order, off[i], results[i]);
    for (const CagePoint& p : on) add_on_cage(rows, cage, coordinates, locator, p);
    for (const auto& [key, row] : rows) all.push_back(row.row(cage, *kind, options.evaluation));
  }
  return all;
}

MeshErrors run_mesh_campaign(const Cage& cage, const std::vector<Vec3<double>>& points,
                             const CageCampaignOptions& options) {
  MeshErrors result;
  result.field.vertices = points;
  for (const CoordinateKind* kind : kinds_matching(options.kinds, cage)) {
    const CageLocator locator(cage, options.triangulation, kind->keeps_quads());
    std::vector<Place> places(points.size());
    for_each_parallel(points.size(), options.jobs, [&](std::size_t i) { places[i] = locator.place(points[i]); });
    const CageCoordinates coordinates(cage, *kind, options.evaluation, options.triangulation);
    std::vector<CageErrors> errors(points.size());
    for_each_parallel(points.size(), options.jobs, [&](std::size_t i) {
      errors[i] = errors_at(coordinates, cage, points[i], expected_sum(*kind, places[i]), 0);
    });
    RowBuilder partition("partition_of_unity", "relative", "mesh", 0), reproduction("linear_reproduction", "relative", "mesh", 0);
    ImageField::Array ones{fmt::format("{}: partition of unity", kind->name), "1", 1, {}};
    ImageField::Array positions{fmt::format("{}: linear reproduction", kind->name), "cage sizes", 1, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Points nearer than the promise reaches are shown in the field and counted, not judged.
      const bool judged = places[i] != Place::TooClose;
      partition.add(judged ? errors[i].partition[0] : NAN, points[i], i);
      reproduction.add(judged ? errors[i].reproduction[0] : NAN, points[i], i);
      ones.values.push_back(errors[i].partition[0]);
      positions.values.push_back(errors[i].reproduction[0]);
    }
    result.rows.push_back(partition.row(cage, *kind, options.evaluation));
    result.rows.push_back(reproduction.row(cage, *kind, options.evaluation));
    result.field.arrays.push_back(std::move(ones));
    result.field.arrays.push_back(std::move(positions));
  }
  return result;
}

}  // namespace cageproof::validation
