// SPDX-License-Identifier: MIT
#include "more_digits.h"

#include "linear_posed.h"
#include "thinness.h"

#include "cageproof/core/geometry/box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace cageproof::deformation {
namespace {

// Derivatives at samples of an element that is a times thinner than what is next to it are a^2 of those elsewhere, and
// each is rounded. What is left of the identity is to be right to 1e-12: with roundings of 1e-16 up to a = 100.
constexpr double thin = 100;

// Evaluations in 50 digits of one layer at one sample, a quarter of a millisecond each in space and less in the plane:
// half a minute.
double most_evaluations(int dimension) { return dimension == 2 ? 3e5 : 1e5; }

// Rounding a pose's vertices may move images by so much of the posed cage's size without a warning.
constexpr double most_moved = 1e-12;

// Before each element, as far from it as it is long, or as much less as keeps them inside: samples are on the cage
// itself, where many methods' images are right whatever densities are.
std::vector<Vec3<double>> points_within(const CageCoordinates& coordinates) {
  const CageElements& elements = coordinates.elements();
  std::vector<Vec3<double>> found;
  found.reserve(elements.count());
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    Vec3<double> middle = Vec3<double>::Zero();
    for (const Vec3<double>& corner : corners) middle += corner / static_cast<double>(corners.size());
    for (double step = (corners[1] - corners[0]).stableNorm(), halvings = 0; halvings < 50; step /= 2, ++halvings) {
      const Vec3<double> point = middle - step * elements.normals()[e];
      const auto phi = coordinates.at<double>(std::span(&point, 1), 0)[0];
      // One inside, nothing outside.
      if (std::accumulate(phi.tensors[0].begin(), phi.tensors[0].end(), 0.) < .5) continue;
      found.push_back(point);
      break;
    }
  }
  return found;
}

// Vertices up to half a unit of their last digits off, each another way.
std::vector<Vec3<Mp50>> nudged(std::vector<Vec3<Mp50>> vertices) {
  using std::abs;
  std::minstd_rand random(20);
  for (Vec3<Mp50>& v : vertices)
    for (Mp50& x : v) {
      const double share = 2. * static_cast<double>(random()) / std::minstd_rand::max() - 1;
      x += share * unit_roundoff<double>() * abs(x);
    }
  return vertices;
}

// A pose in double whose data were found in 50 digits.
class Rounded final : public Deformer<double> {
 public:
  /// \param where the cage is thin, and how
  Rounded(std::shared_ptr<const Deformer<Mp50>> wide, std::string where)
      : wide_(std::move(wide)),
        where_(std::move(where)),
        within_(points_within(wide_->coordinates())),
        tables_(wide_->coordinates().at<double>(within_, 0)) {}

  const CageCoordinates& coordinates() const override { return wide_->coordinates(); }
  int max_order() const override { return wide_->max_order(); }
  DeformationReport prepared() const override {
    DeformationReport report = wide_->prepared();
    report.figures.emplace_back("digits of systems", 50);
    return report;
  }
  std::shared_ptr<const Deformer<double>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = wide_->with_parameters(parameters);
    return other ? std::make_shared<Rounded>(std::move(other), where_) : nullptr;
  }

  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override {
    Pose<Mp50> wide{in_wide(pose.vertices), in_wide(pose.normal_derivatives), in_wide(pose.laplacians),
                    in_wide(pose.laplacian_derivatives)};
    const auto posed = wide_->pose(wide);
    const std::vector<Matrix<Mp50>>& data = data_of(*posed);
    DeformationReport report = posed->report();
    if (!is_rest(pose.vertices)) {
      wide.vertices = nudged(std::move(wide.vertices));
      warn_of_roundings(data, data_of(*wide_->pose(wide)), pose.vertices, report);
    }
    return std::make_unique<LinearPosed<double>>(in_double(data), std::move(report));
  }

 private:
  static const std::vector<Matrix<Mp50>>& data_of(const Posed<Mp50>& posed) {
    return dynamic_cast<const LinearPosed<Mp50>&>(posed).data();
  }
  static std::vector<Matrix<double>> in_double(const std::vector<Matrix<Mp50>>& data) {
    std::vector<Matrix<double>> found;
    found.reserve(data.size());
    for (const Matrix<Mp50>& block : data) found.emplace_back(block.template cast<double>());
    return found;
  }

  // Shifted at most.
  bool is_rest(const std::vector<Vec3<double>>& posed) const {
    const std::vector<Vec3<double>>& rest = coordinates().elements().vertices();
    for (std::size_t v = 0; v < rest.size(); ++v)
      if (posed[v] - posed[0] != rest[v] - rest[0]) return false;
    return true;
  }

  // Posed vertices' roundings grow in derivatives on the cage, and in the systems made of these, as all roundings do.
  void warn_of_roundings(const std::vector<Matrix<Mp50>>& data, const std::vector<Matrix<Mp50>>& other,
                         const std::vector<Vec3<double>>& vertices, DeformationReport& report) const {
    std::vector<Matrix<Mp50>> difference;
    difference.reserve(data.size());
    for (std::size_t b = 0; b < data.size(); ++b) difference.emplace_back(other[b] - data[b]);
    const LinearPosed<double> off(in_double(difference), {});
    double moved = 0;
    const Images<double> steps = off.images(tables_, within_.size(), 0);
    for (const double step : steps.tensors[0]) moved = std::max(moved, std::abs(step));
    const auto [low, high] = box_of(vertices);
    const double share = moved / (high - low).stableNorm();
    report.pose_rounding = share;
    if (share > most_moved)
      report.warnings.push_back(fmt::format(
          "posed vertices are rounded to double, and images are off by about {:.0e} of the posed cage's size with "
          "them: {}",
          share, where_));
  }

  static std::vector<Vec3<Mp50>> in_wide(const std::vector<Vec3<double>>& points) {
    std::vector<Vec3<Mp50>> found;
    found.reserve(points.size());
    for (const Vec3<double>& p : points) found.push_back(convert<Mp50>(p));
    return found;
  }

  std::shared_ptr<const Deformer<Mp50>> wide_;
  std::string where_;
  std::vector<Vec3<double>> within_;
  std::vector<CoordinateTable<double>> tables_;  // there
};

// Says something more of how it was prepared.
class Warned final : public Deformer<double> {
 public:
  Warned(std::shared_ptr<const Deformer<double>> deformer, std::string warning)
      : deformer_(std::move(deformer)), warning_(std::move(warning)) {}

  const CageCoordinates& coordinates() const override { return deformer_->coordinates(); }
  int max_order() const override { return deformer_->max_order(); }
  DeformationReport prepared() const override {
    DeformationReport report = deformer_->prepared();
    report.warnings.push_back(warning_);
    return report;
  }
  std::shared_ptr<const Deformer<double>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = deformer_->with_parameters(parameters);
    return other ? std::make_shared<Warned>(std::move(other), warning_) : nullptr;
  }
  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override { return deformer_->pose(pose); }

 private:
  std::shared_ptr<const Deformer<double>> deformer_;
  std::string warning_;
};

// Of all samples, by the method's parameters that say how often elements are split.
double evaluations_of(const DeformMethod& method, const DeformOptions& options, int dimension, double elements) {
  double samples = 0;
  for (std::size_t i = 0; i < method.parameters.size(); ++i)
    if (method.parameters[i].name == "level" || method.parameters[i].name == "energy_level")
      samples += elements * std::pow(dimension == 2 ? 2 : 4, options.parameters[i]);
  return 4 * samples * elements;
}

}  // namespace

std::shared_ptr<const Deformer<double>> prepared_in_digits_enough(const DeformMethod& method, const Cage& cage,
                                                                  const DeformOptions& options) {
  // In the plane values next to each other lose as much where a cage is thin: the condition of what is solved from them
  // grows as fast.
  const bool loses =
      cage.dimension() == 2 ? evaluations_of(method, options, 2, 1) > 0 : method.takes_derivatives_on_cage;
  if (!loses) return method.prepare(cage, options);
  const CoordinateKind& kind = coordinate_kind_named(method.kind);
  const CageElements elements(cage, kind.keeps_quads, options.triangulation);
  const Thinness thinness = thinness_of(elements);
  if (thinness.times <= thin) return method.prepare(cage, options);
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{options.evaluation, options.triangulation, {}});
  const auto face = cage.parts(kind.keeps_quads, options.triangulation).face_of[thinness.element];
  const std::string where = fmt::format("{} {}", cage.face_label(static_cast<std::size_t>(face)), thinness.what);
  if (coordinates.is_exact_in(ScalarKind::Digits50) &&
      evaluations_of(method, options, elements.dimension(), static_cast<double>(elements.count())) <=
          most_evaluations(elements.dimension()))
    return std::make_shared<Rounded>(method.prepare_in_50_digits(cage, options), where);
  return std::make_shared<Warned>(
      method.prepare(cage, options),
      fmt::format("{}: {}, and 50 digits would take too long", where,
                  method.takes_derivatives_on_cage
                      ? "derivatives of layers there lose digits like its square, images with them"
                      : "densities may lose digits like its square, images with them"));
}

}  // namespace cageproof::deformation
