// SPDX-License-Identifier: MIT
#include "cageproof/validation/one_ring.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/truth.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

constexpr const char* formula_name = "triangle.double_layer";
constexpr double clearance = 2e-2;  // in cage sizes

struct Errors {
  std::array<double, 3> own{}, sum{};
};

using Tensor = std::vector<Mp100>;

double relative(const Tensor& a, const Tensor& b) {
  Tensor difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return static_cast<double>(Mp100(norm(difference) / norm(b)));
}

Tensor widened(const std::vector<double>& tensor) { return {tensor.begin(), tensor.end()}; }

Errors errors_at(const Cage& cage, const std::vector<std::array<int, 3>>& triangles, const Evaluation& evaluation,
                 const Evaluation& reference, const Vec3<double>& point) {
  Errors errors;
  std::array<Tensor, 3> sum, truth_sum;
  for (int o = 1; o < 3; ++o) sum[o] = truth_sum[o] = Tensor(cage.vertices().size() * (o == 1 ? 3 : 9), Mp100(0));
  for (const auto& triangle : triangles) {
    Sample sample;
    for (const int v : triangle) sample.corners.push_back(cage.vertices()[v]);
    sample.point = point;
    const Result<double> found = evaluate<double>(evaluation, sample, 2);
    const Result<Mp100> truth = evaluate<Mp100>(reference, sample, 2);
    for (int o = 1; o < 3; ++o) {
      const Tensor wide = widened(found.of(o));
      errors.own[o] = std::max(errors.own[o], relative(wide, truth.of(o)));
      const int entries = o == 1 ? 3 : 9;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < entries; ++i) {
          sum[o][entries * triangle[k] + i] += wide[entries * k + i];
          truth_sum[o][entries * triangle[k] + i] += truth.of(o)[entries * k + i];
        }
    }
  }
  for (int o = 1; o < 3; ++o) errors.sum[o] = relative(sum[o], truth_sum[o]);
  return errors;
}

ResultRow row_of(const Cage& cage, const std::string& evaluation, const char* check, int order,
                 const std::vector<CagePoint>& points, const std::vector<double>& errors) {
  ErrorHistogram histogram;
  WorstCases worst;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    histogram.add(errors[i]);
    if (worst.wants(errors[i], points[i].index)) worst.add({errors[i], 0, points[i].index, {}, points[i].point, {}});
  }
  ResultRow row;
  row.section = ResultRow::Section::Cage;
  row.subject = formula_name;
  row.evaluation = evaluation;
  row.scalar = "double";
  row.regime = cage.name();
  row.check = check;
  row.place = "off";
  row.order = order;
  row.unit = "relative";
  row.samples = histogram.count();
  row.nonfinite = histogram.nonfinite();
  row.max = row.max_relative = histogram.max();
  row.p999 = histogram.p999();
  row.median = histogram.median();
  row.worst = worst.cases();
  row.histogram.assign(histogram.counts().begin(), histogram.counts().end());
  judge(row);
  return row;
}

Evaluation evaluation_named(const std::string& name) {
  const auto found = EvaluationRegister::instance().find(formula_name, name);
  if (!found) throw InputError(fmt::format("{} has no evaluation '{}'; see `cageproof list`", formula_name, name));
  return *found;
}

}  // namespace

double one_ring_error_at(const Cage& cage, const OneRingOptions& options, std::string_view check, int order,
                         const Vec3<double>& point) {
  const Errors errors = errors_at(cage, cage.triangulate(options.triangulation).triangles,
                                  evaluation_named(options.evaluation), evaluation_named("closed_form"), point);
  return check == "own_derivative" ? errors.own[order] : errors.sum[order];
}

std::vector<ResultRow> run_one_ring_check(const Cage& cage, const OneRingOptions& options) {
  const Evaluation evaluation = evaluation_named(options.evaluation), reference = evaluation_named("closed_form");
  const CageLocator locator(cage, options.triangulation);
  std::vector<CagePoint> points = points_off(cage, locator, options.seed, 4 * options.points);
  std::erase_if(points, [&](const CagePoint& p) { return locator.distance(p.point) < clearance * cage.size(); });
  points.resize(std::min<std::size_t>(points.size(), options.points));
  const auto triangles = cage.triangulate(options.triangulation).triangles;
  std::array<std::vector<double>, 3> own, sum;
  for (const CagePoint& p : points) {
    const Errors errors = errors_at(cage, triangles, evaluation, reference, p.point);
    for (int o = 1; o < 3; ++o) {
      own[o].push_back(errors.own[o]);
      sum[o].push_back(errors.sum[o]);
    }
  }
  std::vector<ResultRow> rows;
  for (int o = 1; o < 3; ++o) {
    rows.push_back(row_of(cage, options.evaluation, "own_derivative", o, points, own[o]));
    rows.push_back(row_of(cage, options.evaluation, "one_ring_sum", o, points, sum[o]));
  }
  return rows;
}

}  // namespace cageproof::validation
