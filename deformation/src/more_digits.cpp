// SPDX-License-Identifier: MIT
#include "more_digits.h"

#include "linear_pose_derivative.h"
#include "pose_roundings.h"
#include "thinness.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

// Derivatives at samples of an element that is a times thinner than what is next to it are a^2 of those elsewhere, and
// each is rounded. What is left of the identity is to be right to 1e-12: with roundings of 1e-16 up to a = 100.
constexpr double thin = 100;

// Values at samples lose a factor a where derivatives lose a^2, and only in the difference between a pose and a
// similarity: more than 1e-10 of it here. At 1e8, double has no digits left of them.
constexpr double thin_for_values = 1e6;

// In the plane values next to each other lose as much where a cage is thin: the condition of what is solved from them
// grows as fast.
bool is_thin_for(const Thinness& thinness, int dimension, bool takes_derivatives) {
  return thinness.times > (dimension == 2 || takes_derivatives ? thin : thin_for_values);
}

// Evaluations in 50 digits of one layer at one sample, a quarter of a millisecond each in space and less in the plane:
// half a minute.
double most_evaluations(int dimension) { return dimension == 2 ? 3e5 : 1e5; }

const std::vector<Matrix<Mp50>>& data_of(const Posed<Mp50>& posed) {
  return dynamic_cast<const LinearPosed<Mp50>&>(posed).data();
}

template <Scalar To, Scalar From>
std::vector<Matrix<To>> blocks_in(const std::vector<Matrix<From>>& data) {
  std::vector<Matrix<To>> found;
  found.reserve(data.size());
  for (const Matrix<From>& block : data) found.emplace_back(block.template cast<To>());
  return found;
}

template <Scalar To, Scalar From>
std::vector<Vec3<To>> points_in(const std::vector<Vec3<From>>& points) {
  std::vector<Vec3<To>> found;
  found.reserve(points.size());
  for (const Vec3<From>& p : points) found.push_back(convert<To>(p));
  return found;
}

// A derivative whose data are found in 50 digits, and whose points' coordinates are double's.
class RoundedDerivative final : public PoseDerivative<double> {
 public:
  explicit RoundedDerivative(std::unique_ptr<const PoseDerivative<Mp50>> wide) : wide_(std::move(wide)) {}

  std::unique_ptr<const Posed<double>> along(const std::vector<Vec3<double>>& change) const override {
    return std::make_unique<LinearPosed<double>>(blocks_in<double>(data_of(*wide_->along(points_in<Mp50>(change)))),
                                                 DeformationReport());
  }
  std::vector<Matrix<double>> nothing() const override { return blocks_in<double>(wide_->nothing()); }
  void gather(std::span<const CoordinateTable<double>> coordinates, std::size_t points, std::span<const double> weights,
              std::vector<Matrix<double>>& gathered) const override {
    gather_rows(coordinates, points, weights, gathered);
  }
  std::vector<Vec3<double>> back(const std::vector<Matrix<double>>& gathered) const override {
    return points_in<double>(wide_->back(blocks_in<Mp50>(gathered)));
  }

 private:
  std::unique_ptr<const PoseDerivative<Mp50>> wide_;
};

// A pose in double whose data were found in 50 digits.
class Rounded final : public Deformer<double> {
 public:
  Rounded(std::shared_ptr<const Deformer<Mp50>> wide, std::shared_ptr<const PoseRoundings> roundings)
      : wide_(std::move(wide)), roundings_(std::move(roundings)) {}

  const CageCoordinates& coordinates() const override { return wide_->coordinates(); }
  int max_order() const override { return wide_->max_order(); }
  DeformationReport prepared() const override {
    DeformationReport report = wide_->prepared();
    report.figures.emplace_back("digits of systems", 50);
    return report;
  }
  std::shared_ptr<const Deformer<double>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = wide_->with_parameters(parameters);
    return other ? std::make_shared<Rounded>(std::move(other), roundings_) : nullptr;
  }

  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override {
    Pose<Mp50> wide{in_wide(pose.vertices), in_wide(pose.normal_derivatives), in_wide(pose.laplacians),
                    in_wide(pose.laplacian_derivatives)};
    const auto posed = wide_->pose(wide);
    const std::vector<Matrix<Mp50>>& data = data_of(*posed);
    DeformationReport report = posed->report();
    if (!roundings_->is_rest(pose.vertices)) {
      wide.vertices = nudged(std::move(wide.vertices));
      std::vector<Matrix<Mp50>> moved = data_of(*wide_->pose(wide));
      for (std::size_t b = 0; b < data.size(); ++b) moved[b] -= data[b];
      roundings_->state(roundings_->images(LinearPosed<double>(in_double(moved), {})), pose.vertices, report);
    }
    return std::make_unique<LinearPosed<double>>(in_double(data), std::move(report));
  }
  std::unique_ptr<const PoseDerivative<double>> derivative(const Pose<double>& pose) const override {
    auto wide = wide_->derivative({in_wide(pose.vertices), in_wide(pose.normal_derivatives), in_wide(pose.laplacians),
                                   in_wide(pose.laplacian_derivatives)});
    return wide ? std::make_unique<RoundedDerivative>(std::move(wide)) : nullptr;
  }

 private:
  static std::vector<Matrix<double>> in_double(const std::vector<Matrix<Mp50>>& data) {
    return blocks_in<double>(data);
  }
  static std::vector<Vec3<Mp50>> in_wide(const std::vector<Vec3<double>>& points) { return points_in<Mp50>(points); }

  std::shared_ptr<const Deformer<Mp50>> wide_;
  std::shared_ptr<const PoseRoundings> roundings_;
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
  std::unique_ptr<const PoseDerivative<double>> derivative(const Pose<double>& pose) const override {
    return deformer_->derivative(pose);
  }

 private:
  std::shared_ptr<const Deformer<double>> deformer_;
  std::string warning_;
};

double evaluations_at(int level, int dimension, double elements) {
  return 4 * std::pow(dimension == 2 ? 2 : 4, level) * elements * elements;
}

// The number of evaluations at all samples, by the method's parameters that say how often elements are split.
double evaluations_of(const DeformMethod& method, const DeformOptions& options, int dimension, double elements) {
  double all = 0;
  for (std::size_t i = 0; i < method.parameters.size(); ++i)
    if (method.parameters[i].name == "level" || method.parameters[i].name == "energy_level")
      all += evaluations_at(static_cast<int>(options.parameters[i]), dimension, elements);
  return all;
}

}  // namespace

std::shared_ptr<const Deformer<double>> prepared_in_digits_enough(const DeformMethod& method, const Cage& cage,
                                                                  const DeformOptions& options) {
  if (evaluations_of(method, options, cage.dimension(), 1) == 0) return method.prepare(cage, options);
  const CoordinateKind& kind = coordinate_kind_named(method.kind);
  const CageElements elements(cage, kind.keeps_quads, options.triangulation);
  const auto said_of = [&](const Thinness& thinness) {
    const auto face = cage.parts(kind.keeps_quads, options.triangulation).face_of[thinness.element];
    return fmt::format("{} {}", cage.face_label(static_cast<std::size_t>(face)), thinness.what);
  };
  const Thinness thinness = thinness_of(elements);
  if (!is_thin_for(thinness, cage.dimension(), method.takes_derivatives_on_cage)) {
    // A small element is turned by the roundings of its posed corners.
    const Thinness smallness = smallness_of(elements);
    auto deformer = method.prepare(cage, options);
    return smallness.times > thin ? stating_pose_roundings(std::move(deformer), said_of(smallness)) : deformer;
  }
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{options.evaluation, options.triangulation, {}});
  const std::string where = said_of(thinness);
  if (coordinates.is_exact_in(ScalarKind::Digits50) &&
      evaluations_of(method, options, elements.dimension(), static_cast<double>(elements.count())) <=
          most_evaluations(elements.dimension())) {
    auto wide = method.prepare_in_50_digits(cage, options);
    return std::make_shared<Rounded>(wide, std::make_shared<const PoseRoundings>(wide->coordinates(), where));
  }
  return std::make_shared<Warned>(
      method.prepare(cage, options),
      fmt::format("{}: {}, and 50 digits would take too long", where,
                  method.takes_derivatives_on_cage
                      ? "derivatives of layers there lose digits like its square, images with them"
                      : "densities may lose digits like its square, images with them"));
}

bool can_have_50_digits(const CageElements& elements, int level) {
  return evaluations_at(level, elements.dimension(), static_cast<double>(elements.count())) <=
         most_evaluations(elements.dimension());
}

bool wants_50_digits(const CageElements& elements, int level, bool takes_derivatives) {
  return is_thin_for(thinness_of(elements), elements.dimension(), takes_derivatives) &&
         can_have_50_digits(elements, level);
}

}  // namespace cageproof::deformation
