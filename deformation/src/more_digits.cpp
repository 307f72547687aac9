// SPDX-License-Identifier: MIT
#include "more_digits.h"

#include "linear_posed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// Samples of an element that is a times as long as high lie 1/a beside its edges, where second derivatives are a^2 of
// those elsewhere, and each is rounded. What is left of the identity is to be right to 1e-12: with roundings of 1e-16
// up to a = 100.
constexpr double thin = 100;

// Evaluations in 50 digits of one layer at one sample, a quarter of a millisecond each: half a minute.
constexpr double most_evaluations = 1e5;

struct Thinnest {
  std::size_t element = 0;
  double aspect = 0;
};

double aspect_of(const CageElements& elements, std::size_t e) {
  const auto vertices = elements.vertices_of(e);
  if (vertices.size() != 3) return 1;
  const auto at = [&](int k) { return elements.vertices()[vertices[k % 3]]; };
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (at(k + 1) - at(k)).stableNorm());
  const Vec3<double> u = (at(1) - at(0)) / longest, v = (at(2) - at(0)) / longest;
  return 1 / u.cross(v).norm();
}

Thinnest thinnest_of(const CageElements& elements) {
  Thinnest found;
  for (std::size_t e = 0; e < elements.count(); ++e)
    if (const double aspect = aspect_of(elements, e); !(aspect <= found.aspect)) found = {e, aspect};
  return found;
}

// A pose in double whose data were found in 50 digits.
class Rounded final : public Deformer<double> {
 public:
  explicit Rounded(std::shared_ptr<const Deformer<Mp50>> wide) : wide_(std::move(wide)) {}

  const CageCoordinates& coordinates() const override { return wide_->coordinates(); }
  int max_order() const override { return wide_->max_order(); }
  DeformationReport prepared() const override {
    DeformationReport report = wide_->prepared();
    report.figures.emplace_back("digits of systems", 50);
    return report;
  }
  std::shared_ptr<const Deformer<double>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = wide_->with_parameters(parameters);
    return other ? std::make_shared<Rounded>(std::move(other)) : nullptr;
  }

  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override {
    const auto posed = wide_->pose({in_wide(pose.vertices), in_wide(pose.normal_derivatives), in_wide(pose.laplacians),
                                    in_wide(pose.laplacian_derivatives)});
    std::vector<Matrix<double>> data;
    for (const Matrix<Mp50>& block : dynamic_cast<const LinearPosed<Mp50>&>(*posed).data())
      data.emplace_back(block.template cast<double>());
    return std::make_unique<LinearPosed<double>>(std::move(data), posed->report());
  }

 private:
  static std::vector<Vec3<Mp50>> in_wide(const std::vector<Vec3<double>>& points) {
    std::vector<Vec3<Mp50>> found;
    found.reserve(points.size());
    for (const Vec3<double>& p : points) found.push_back(convert<Mp50>(p));
    return found;
  }

  std::shared_ptr<const Deformer<Mp50>> wide_;
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
double evaluations_of(const DeformMethod& method, const DeformOptions& options, double elements) {
  double samples = 0;
  for (std::size_t i = 0; i < method.parameters.size(); ++i)
    if (method.parameters[i].name == "level" || method.parameters[i].name == "energy_level")
      samples += elements * std::pow(4, options.parameters[i]);
  return 4 * samples * elements;
}

}  // namespace

std::shared_ptr<const Deformer<double>> prepared_in_digits_enough(const DeformMethod& method, const Cage& cage,
                                                                  const DeformOptions& options) {
  if (!method.takes_derivatives_on_cage) return method.prepare(cage, options);
  const CoordinateKind& kind = coordinate_kind_named(method.kind);
  const CageElements elements(cage, kind.keeps_quads, options.triangulation);
  const Thinnest thinnest = thinnest_of(elements);
  if (thinnest.aspect <= thin) return method.prepare(cage, options);
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{options.evaluation, options.triangulation, {}});
  if (coordinates.is_exact_in(ScalarKind::Digits50) &&
      evaluations_of(method, options, static_cast<double>(elements.count())) <= most_evaluations)
    return std::make_shared<Rounded>(method.prepare_in_50_digits(cage, options));
  return std::make_shared<Warned>(
      method.prepare(cage, options),
      fmt::format("{} is {:.2g} times as long as high: derivatives of layers there lose digits like its square, images "
                  "with them, and 50 digits would take too long",
                  cage.face_label(static_cast<std::size_t>(
                      cage.parts(kind.keeps_quads, options.triangulation).face_of[thinnest.element])),
                  thinnest.aspect));
}

}  // namespace cageproof::deformation
