// SPDX-License-Identifier: MIT
// Products with the derivative of a deformer's images by the posed cage's vertices, in both directions, at the bent
// pose: against differences of the images, and against each other.
#pragma once

#include "bent_images.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace cageproof::validation {

/// A deformer's derivative J by the vertices of the bent pose. Errors are NaN where there is no J or no image. Safe
/// from any thread.
class PoseProducts {
 public:
  using Prepare = std::function<std::shared_ptr<const deformation::Deformer<Mp50>>()>;

  /// \param method the deformer's \param in_50_digits called when differences in 50 digits are first asked for
  PoseProducts(std::shared_ptr<const Cage> cage, const deformation::DeformMethod& method,
               std::function<std::shared_ptr<const deformation::Deformer<double>>()> deformer, Prepare in_50_digits);

  /// Whether the method has J with its parameters. Where it refuses the pose, whoever asks is told.
  bool exist() const;

  /// |J c - difference of images| over the size of J's terms, at least a cage size; c is generic_change(). Central
  /// differences: by R = Mp50 of second order and a step of 1e-16 sizes, by double of fourth order and 2^-13 sizes.
  template <Scalar R>
  double error_of_jvp(const Vec3<double>& point) const;

  /// |w . (J c) - (J' w) . c| in roundings of the terms of the sum over vertices and axes; w is a generic direction.
  double roundings_of_adjoint(const Vec3<double>& point) const;

 private:
  using Derivative = std::shared_ptr<const deformation::PoseDerivative<double>>;
  template <Scalar R>
  struct Moved {
    std::shared_ptr<const deformation::Deformer<R>> deformer;
    std::vector<std::unique_ptr<const deformation::Posed<R>>> posed;  // by 1, -1, 2, -2 steps
  };
  struct Along {
    Derivative derivative;
    std::unique_ptr<const deformation::Posed<double>> posed;  // whose images are J c
  };

  std::vector<double> jvp(const Vec3<double>& point) const;
  std::vector<double> vjp(const Vec3<double>& point, const std::vector<double>& weights) const;
  /// Sums of the absolute terms of each component of J c, from J's rows.
  std::vector<double> terms(const Vec3<double>& point) const;
  template <Scalar R>
  Moved<R> moved(std::shared_ptr<const deformation::Deformer<R>> deformer, const R& step, int steps) const;
  template <Scalar R>
  std::vector<double> differences(const Vec3<double>& point) const;

  std::shared_ptr<const Cage> cage_;
  std::vector<Vec3<double>> change_;
  Lazy<std::shared_ptr<const deformation::Deformer<double>>> deformer_;
  Lazy<Along> along_;
  Lazy<Moved<double>> in_double_;
  Lazy<Moved<Mp50>> in_50_digits_;
};

}  // namespace cageproof::validation
