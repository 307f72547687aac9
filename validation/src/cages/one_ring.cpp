// SPDX-License-Identifier: MIT
#include "one_ring.h"

#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/truth.h"
#include "promises/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

const std::string formula_name(one_ring_formula);
constexpr double clearance = 2e-2;  // in cage sizes

// Whether a triangle is so much smaller than the cage that the form as printed has not the promised digits: it loses
// the square of a distance over the size of a triangle.
bool has_small_faces(const Cage& cage, const std::vector<std::array<int, 3>>& triangles) {
  constexpr double promised = 1e-9;
  double shortest = cage.size();
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k)
      shortest = std::min(shortest, (cage.vertices()[t[(k + 1) % 3]] - cage.vertices()[t[k]]).stableNorm());
  const double ratio = cage.size() / shortest;
  return unit_roundoff<double>() * ratio * ratio > promised;
}

using Tensor = std::vector<Mp100>;

double relative(const Tensor& a, const Tensor& b, const Mp100& size) {
  Tensor difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return static_cast<double>(Mp100(norm(difference) / size));
}

template <class R>
Tensor widened(const std::vector<R>& tensor) {
  return {tensor.begin(), tensor.end()};
}

// Errors of sums are relative to the terms that were added up, which cancel where a cage has thin walls. All in units
// of the cage's size, since whose derivatives an evaluation gives is no question of its exponent range.
OneRingErrors ring_errors_at(const Cage& cage, const std::vector<std::array<int, 3>>& triangles,
                             const Evaluation& evaluation, const Evaluation& reference, const Vec3<double>& point) {
  OneRingErrors errors;
  const double scale = std::ldexp(1., -std::ilogb(cage.size()));
  std::array<Tensor, 3> sum, truth_sum;
  std::array<Mp100, 3> of_terms{};
  for (int o = 1; o < 3; ++o) sum[o] = truth_sum[o] = Tensor(cage.vertices().size() * (o == 1 ? 3 : 9), Mp100(0));
  for (const auto& triangle : triangles) {
    Sample sample;
    for (const int v : triangle) sample.corners.emplace_back(cage.vertices()[v] * scale);
    sample.point = point * scale;
    const Result<double> found = evaluate<double>(evaluation, sample, 2);
    // 50 digits are forty more than are promised.
    const Result<Mp50> in_50_digits = evaluate<Mp50>(reference, sample, 2);
    for (int o = 1; o < 3; ++o) {
      const Tensor wide = widened(found.of(o)), truth = widened(in_50_digits.of(o));
      errors.own[o] = std::max(errors.own[o], relative(wide, truth, norm(truth)));
      of_terms[o] += norm(wide);
      const int entries = o == 1 ? 3 : 9;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < entries; ++i) {
          sum[o][entries * triangle[k] + i] += wide[entries * k + i];
          truth_sum[o][entries * triangle[k] + i] += truth[entries * k + i];
        }
    }
  }
  for (int o = 1; o < 3; ++o) errors.sum[o] = relative(sum[o], truth_sum[o], of_terms[o]);
  return errors;
}

Evaluation chosen(const OneRingOptions& options) {
  if (options.evaluation.empty()) return *EvaluationRegister::instance().with_role(formula_name, Role::Recommended);
  return evaluation_named(formula_name, options.evaluation);
}

// Off the cage, by at least the clearance.
std::vector<CagePoint> points_for(const Cage& cage, const OneRingOptions& options) {
  const CageLocator locator(cage, options.triangulation);
  std::vector<CagePoint> points = points_off(cage, locator, options.seed, 4 * options.points);
  std::erase_if(points, [&](const CagePoint& p) { return locator.distance(p.point) < clearance * cage.size(); });
  points.resize(std::min<std::size_t>(points.size(), options.points));
  return points;
}

class OneRingMeasurement final : public Measurement {
 public:
  OneRingMeasurement(std::shared_ptr<const Cage> cage, const OneRingOptions& options)
      : cage_(std::move(cage)),
        ring_(cage_, options),
        blocks_(block_count(options.points, 4)),
        points_([this, options] { return points_for(*cage_, options); }) {}

  std::string name() const override {
    return fmt::format("{}, one ring, {}", cage_->name(), ring_.evaluation().name());
  }
  int blocks() const override { return blocks_; }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const auto& question : ring_.questions()) add_rows_of(question, rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    const std::vector<CagePoint>& points = points_.get();
    PartialResult gathered;
    const auto questions = ring_.questions();
    for (std::size_t i = block; i < points.size(); i += blocks_) {
      const OneRingAt at = ring_.at(points[i].point, points[i].index);
      for (const auto& question : questions) record(question, at, gathered.rows);
    }
    return gathered;
  }

 private:
  std::shared_ptr<const Cage> cage_;
  OneRing ring_;
  int blocks_;
  Lazy<std::vector<CagePoint>> points_;
};

}  // namespace

bool one_ring_exists_on(const Cage& cage) { return cage.dimension() == formula_named(formula_name).dim(); }

OneRing::OneRing(std::shared_ptr<const Cage> cage, const OneRingOptions& options)
    : cage_(std::move(cage)),
      evaluation_(chosen(options)),
      reference_(truth_source(formula_named(formula_name)).evaluation),
      triangles_(cage_->triangulate(options.triangulation).triangles) {}

std::vector<Question<OneRingAt>> OneRing::questions() const {
  const auto question = [&](const char* check, std::array<double, 3> OneRingErrors::*errors) {
    Question<OneRingAt> made;
    made.key = {RowKey::Section::Cage, formula_name, evaluation_.name(), "double", cage_->name(), check, "off", 0};
    made.unit = "relative";
    made.orders = {1, 2};
    made.ask = [errors](const OneRingAt& at) {
      std::array<Finding, 3> found;
      for (int o = 1; o < 3; ++o) {
        const double error = (at.errors().*errors)[o];
        found[o] = {Finding::Status::Measured, error, error};
      }
      return found;
    };
    return made;
  };
  const bool keeps = evaluation_.role() == Role::Recommended || !has_small_faces(*cage_, triangles_);
  return {question("own_derivative", &OneRingErrors::own),
          question(keeps ? "one_ring_sum" : "one_ring_sum_small_faces", &OneRingErrors::sum)};
}

OneRingAt OneRing::at(const Vec3<double>& point, std::uint64_t index) const {
  return {point, index, [this, point] { return ring_errors_at(*cage_, triangles_, evaluation_, reference_, point); }};
}

std::unique_ptr<const Measurement> one_ring_measurement(std::shared_ptr<const Cage> cage,
                                                        const OneRingOptions& options) {
  return std::make_unique<OneRingMeasurement>(std::move(cage), options);
}

std::vector<ResultRow> run_one_ring_check(const Cage& cage, const OneRingOptions& options) {
  if (!one_ring_exists_on(cage)) return {};
  Measurements measurements;
  measurements.push_back(one_ring_measurement(std::make_shared<const Cage>(cage), options));
  return judged(measure_all(measurements, options.jobs).rows).rows;
}

}  // namespace cageproof::validation
