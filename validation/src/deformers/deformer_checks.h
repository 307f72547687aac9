// SPDX-License-Identifier: MIT
// Questions to a deformer on a cage: which maps of space it keeps, and whether its images and their derivatives are
// right.
#pragma once

#include "cageproof/deformation/deformer.h"
#include "cageproof/validation/cage_campaign.h"
#include "bent_images.h"
#include "deformer_poses.h"
#include "pose_products.h"
#include "cages/mirror_symmetry.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/question.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::validation {

/// A method with one of the values of its own parameters that have names, the others at their defaults.
struct DeformerVariant {
  const deformation::DeformMethod* method;
  std::string name;                ///< "stretch=rms"; empty for methods without such parameters
  std::vector<double> parameters;  ///< DeformOptions::parameters
  bool is_default = true;          ///< whether all of them are at their defaults
};

/// Largest number of elements of a cage on which checks are asked that take seconds on larger ones.
inline constexpr std::size_t few_elements = 12;

/// All variants of a method, in the order of the parameters and their names.
std::vector<DeformerVariant> variants_of(const deformation::DeformMethod& method);

/// The variant of that name. \throws InputError where there is none
DeformerVariant variant_named(const deformation::DeformMethod& method, std::string_view name);

/// An error of an image, with and without excuses.
struct DeformerError {
  /// In cage sizes (Jacobians: as they are; second derivatives: times the size), divided by the excuses.
  double error = std::numeric_limits<double>::quiet_NaN();
  double plain = std::numeric_limits<double>::quiet_NaN();  ///< without excuses
};

/// Reasons for which images may err by more than is promised next to the origin.
struct Excuses {
  double condition = 1;  ///< of the worst system that was solved; up to 1e3 it excuses nothing, beyond 1e8 nothing more
  double rounding = 0;   ///< of the largest coordinate, in cage sizes; up to 2.5e-14 it excuses nothing

  /// How many times as large as without excuses an error may be: up to 1e6, so that of images that are promised to
  /// 1e-13 sizes seven digits are asked whatever the condition is; or, where that is more, what four roundings of
  /// coordinates are, which no method can do without: from 2e8 sizes off, and up to 1e8, which leaves five digits.
  double factor() const;
};

/// \param plain in cage sizes
DeformerError excused(double plain, const Excuses& excuses);

/// Excuses::rounding of a cage: about 1e-16 for one next to the origin, 1e-13 for one a thousand sizes off.
/// \param posed its vertices elsewhere, which are rounded, too
double rounding_of_coordinates(const Cage& cage, const std::vector<Vec3<double>>& posed = {});

/// A deformer and its questions. Safe from any thread.
class DeformerChecks {
 public:
  /// \param like the method prepared for the same cage with other parameters, whose coordinates are taken where they
  /// serve; null for none \throws InputError for a cage that the method refuses
  DeformerChecks(std::shared_ptr<const Cage> cage, DeformerVariant variant, Triangulation rule,
                 const deformation::Deformer<double>* like = nullptr);

  /// keeps_rigid, keeps_scale, keeps_mirror, keeps_linear: images with those of the map that poses the cage, in double.
  /// Where they differ by more than is promised, on small cages, from where RoundedPose moves them.
  /// keeps_linear_with_normals, of methods that take normal derivatives: the same with those of the map.
  /// keeps_offset, by default parameters on small cages: images of the same cage far from the origin, posed as it is,
  /// with the points.
  /// keeps_symmetry, on cages that are their own mirror images across an axis, and posed symmetrically: images of
  /// mirrored points with the mirrored images, where the deformer's elements are symmetric, too.
  /// keeps_symmetry_of_quads: the same where the quads are, and not the triangles that they are split in.
  /// deformer_truth: images and their derivatives in double with those in 50 digits, where these are prompt; in cage
  /// sizes, or parts of the image's distance from the posed cage or of the derivative, whichever is less. Methods
  /// that solve systems for the cage are asked only on small cages and with default parameters; kinds that keep quads
  /// only with default parameters.
  /// deformer_jacobian: derivatives with central differences of the images and of the Jacobian, in 50 digits where
  /// these are prompt, else in double, along one direction per point, in the same unit.
  /// deformer_by_quadrature: images with those that an adaptive rule gives, on small cages, by default parameters.
  /// pose_derivative: products with the derivative by posed vertices with differences in 50 digits, where these are
  /// prompt; pose_derivative_in_double: elsewhere in double. pose_derivative_transposed: both directions are one
  /// matrix. Of all methods and variants that have it (PoseProducts). second_route: images in 50 digits with those of
  /// second_routes::LayerRoute, of methods that solve for densities; in space by default parameters, in the plane of
  /// the cage turned. A question's place is its pose, which is solved for when the question is first asked. Valid while
  /// this lives.
  std::vector<Question<PointAt>> questions() const;

 private:
  /// Errors by order; NaN where there is no image.
  using Errors = std::array<DeformerError, 3>;
  /// The question's errors at a point.
  using Ask = std::function<Errors(const Vec3<double>&)>;
  template <class R>
  using Prepared = std::shared_ptr<const deformation::Deformer<R>>;
  template <class R>
  Prepared<R> prepared(const std::string& evaluation) const;
  /// Few elements and, where quads are kept, few corners of them.
  bool has_few_elements() const;
  bool has_50_digits() const;
  bool is_prompt_in_50_digits() const;
  std::optional<std::string> quadrature() const;
  Question<PointAt> question(std::string_view check, std::string_view pose, ScalarKind scalar, int lowest, int highest,
                             Ask ask) const;
  Ask kept(const SpaceMap& map, bool with_normals) const;
  Ask kept_far_off(const SpaceMap& offset) const;
  Ask mirrored(const MirrorSymmetry& mirror) const;
  Ask compared_with_truth(int order) const;
  Ask compared_with_quadrature() const;
  bool has_second_route() const;
  Ask compared_with_second_route() const;
  void add_products(std::vector<Question<PointAt>>& all) const;
  template <class R>
  Ask differences() const;
  template <class R>
  const BentImages<R>& bent_images() const;
  Errors compared(const deformation::Images<double>& images, const deformation::Images<Mp50>& with, int order,
                  double condition) const;
  /// Excuses for images in double, from a system's condition and from the positions of the cage and its pose.
  Excuses with_condition(double condition, const std::vector<Vec3<double>>& posed = {}) const {
    return {condition, rounding_of_coordinates(*cage_, posed)};
  }

  std::shared_ptr<const Cage> cage_;
  DeformerVariant variant_;
  Triangulation rule_;
  Prepared<double> deformer_;
  Lazy<Prepared<Mp50>> in_50_digits_;
  BentImages<double> bent_;
  BentImages<Mp50> bent_in_50_digits_;
  PoseProducts products_;
  Vec3<double> seen_from_;  ///< a vertex of the bent cage
  std::optional<CageCoordinates> prior_;
};

}  // namespace cageproof::validation
