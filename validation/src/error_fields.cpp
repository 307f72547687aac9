// SPDX-License-Identifier: MIT
#include "cageproof/validation/error_fields.h"

#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/campaign.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double masked = std::numeric_limits<double>::quiet_NaN();

ImageField empty_field(const SlicePlan& slice, std::string name) {
  ImageField field;
  field.name = std::move(name);
  field.points = slice.points;
  field.origin = slice.origin;
  field.spacing = slice.spacing;
  return field;
}

std::size_t count_of(const SlicePlan& slice) {
  return static_cast<std::size_t>(slice.points[0]) * slice.points[1] * slice.points[2];
}

Vec3<double> point_of(const SlicePlan& slice, std::size_t i) {
  const std::size_t nx = slice.points[0], ny = slice.points[1];
  const Vec3<double> steps(static_cast<double>(i % nx), static_cast<double>(i / nx % ny),
                           static_cast<double>(i / (nx * ny)));
  return slice.origin + slice.spacing.cwiseProduct(steps);
}

// A file name from a cage's name, which may be a path.
std::string file_name(const Cage& cage) {
  std::string name = cage.name().substr(cage.name().find_last_of('/') + 1);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return name;
}

}  // namespace

SlicePlan slice_through(const Cage& cage, int resolution) {
  Vec3<double> low = cage.vertices().front(), high = low;
  for (const auto& v : cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Vec3<double> size = high - low;
  int across = 2;
  for (int c = 0; c < 3; ++c)
    if (size[c] < size[across]) across = c;
  SlicePlan slice{low - 0.05 * size, Vec3<double>::Ones(), {resolution, resolution, resolution}};
  // Off the middle, where symmetric cages have edges.
  slice.origin[across] = low[across] + 0.47 * size[across];
  slice.points[across] = 1;
  for (int c = 0; c < 3; ++c)
    if (c != across) slice.spacing[c] = 1.1 * size[c] / (resolution - 1);
  return slice;
}

ImageField reproduction_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                              Triangulation rule, int resolution, int jobs, const std::vector<double>& parameters) {
  const SlicePlan slice = slice_through(cage, resolution);
  const CageCoordinates coordinates(cage, kind, evaluation, rule, parameters);
  const CageLocator locator(cage, rule, kind.keeps_quads());
  ImageField field = empty_field(slice, fmt::format("{}.{}.{}.reproduction", file_name(cage), kind.name, evaluation));
  const std::size_t count = count_of(slice);
  field.arrays = {{"partition of unity", "1", 1, std::vector<double>(count)},
                  {"linear reproduction", "cage sizes", 1, std::vector<double>(count)}};
  for_each_parallel(count, jobs, [&](std::size_t i) {
    const Vec3<double> p = point_of(slice, i);
    const Place place = locator.place(p);
    const CageErrors errors = errors_at(coordinates, cage, p, expected_sum(kind, place), 0);
    const bool shown = place != Place::TooClose;
    field.arrays[0].values[i] = shown ? errors.partition[0] : masked;
    field.arrays[1].values[i] = shown ? errors.reproduction[0] : masked;
  });
  return field;
}

ImageField coordinate_error_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                                  Triangulation rule, int resolution, int jobs) {
  const SlicePlan slice = slice_through(cage, resolution);
  const CageCoordinates coordinates(cage, kind, evaluation, rule);
  const CageCoordinates reference(cage, kind, "closed_form", rule);
  ImageField field = empty_field(slice, fmt::format("{}.{}.{}.error", file_name(cage), kind.name, evaluation));
  const std::size_t count = count_of(slice);
  field.arrays = {{"relative error", "1", 1, std::vector<double>(count)}};
  for_each_parallel(count, jobs, [&](std::size_t i) {
    field.arrays[0].values[i] = truth_errors_at(coordinates, reference, point_of(slice, i), 0)[0];
  });
  return field;
}

ImageField coordinate_difference_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation, const std::string& other,
                                       Triangulation rule, int resolution, int jobs) {
  const SlicePlan slice = slice_through(cage, resolution);
  const CageCoordinates first(cage, kind, evaluation, rule), second(cage, kind, other, rule);
  ImageField field = empty_field(slice, fmt::format("{}.{}.{}.difference", file_name(cage), kind.name, evaluation));
  const std::size_t count = count_of(slice);
  field.arrays = {{"difference", "1", 1, std::vector<double>(count)}};
  for_each_parallel(count, jobs, [&](std::size_t i) {
    const auto a = first.at<double>(point_of(slice, i), 0), b = second.at<double>(point_of(slice, i), 0);
    double worst = 0;
    for (std::size_t block = 0; block < a.size(); ++block)
      for (std::size_t k = 0; k < a[block].value.size(); ++k) {
        const double d = std::abs(a[block].value[k] - b[block].value[k]);
        worst = std::isnan(d) ? std::numeric_limits<double>::infinity() : std::max(worst, d);
      }
    field.arrays[0].values[i] = worst;
  });
  return field;
}

ImageField formula_error_field(const std::vector<std::array<Vec3<double>, 3>>& triangles, const Formula& formula,
                               const Evaluation& evaluation, int order, const SlicePlan& slice, int jobs) {
  const Evaluation reference = *EvaluationRegister::instance().find(formula.name, "closed_form");
  ImageField field = empty_field(
      slice, fmt::format("{}.{}.{}", formula.name, evaluation.name(), order == 0 ? "value" : order == 1 ? "gradient" : "hessian"));
  const std::size_t count = count_of(slice);
  field.arrays = {{"value", "1", 1, std::vector<double>(count)}, {"relative error", "1", 1, std::vector<double>(count)}};
  std::vector<double> presets;
  for (const Parameter& p : formula.parameters) presets.push_back(p.preset);
  for_each_parallel(count, jobs, [&](std::size_t i) {
    Mp100 error = 0, size = 0;
    for (const auto& t : triangles) {
      const Sample sample{{t.begin(), t.end()}, point_of(slice, i), presets, 0, i};
      const Result<double> f = evaluate<double>(evaluation, sample, order);
      const Result<Mp50> truth = evaluate<Mp50>(reference, sample, order);
      for (std::size_t k = 0; k < f.of(order).size(); ++k) {
        const Mp100 exact(truth.of(order)[k]), d = Mp100(f.of(order)[k]) - exact;
        error += d * d;
        size += exact * exact;
      }
    }
    field.arrays[0].values[i] = static_cast<double>(Mp100(sqrt(size)));
    field.arrays[1].values[i] = !isfinite(size) ? masked
                                : !isfinite(error) ? std::numeric_limits<double>::infinity()
                                : error == 0       ? 0
                                                   : static_cast<double>(Mp100(sqrt(error / size)));
  });
  return field;
}

}  // namespace cageproof::validation
