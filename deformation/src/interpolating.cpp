// SPDX-License-Identifier: MIT
// Interpolating deformers: coordinates of values times the posed vertices ([T18] Section 5).
#include "linear_pose_derivative.h"
#include "plane/solved_systems.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class Interpolating final : public Deformer<R> {
 public:
  Interpolating(const Cage& cage, std::string_view kind, const DeformOptions& options)
      : coordinates_(cage, coordinate_kind_named(kind),
                     CoordinateOptions{options.evaluation, options.triangulation, options.parameters}) {}

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return report_on_true(coordinates_); }
  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{rows_of(pose.vertices, coordinates_.dimension())},
                                            DeformationReport());
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    return std::make_unique<LinearPoseDerivative<R>>(coordinates_.dimension(), pose.vertices.size(), RowSlopes<R>());
  }

 private:
  CageCoordinates coordinates_;
};

struct MeanValue {
  static constexpr std::string_view kind = "mean_value";
};
struct QuadMeanValue {
  static constexpr std::string_view kind = "quad_mean_value";
};
struct SphericalMeanValue {
  static constexpr std::string_view kind = "spherical_mean_value";
};
struct MaximumEntropy {
  static constexpr std::string_view kind = "maximum_entropy";
};
struct Harmonic {
  static constexpr std::string_view kind = "harmonic";
};
struct TrueHarmonic {
  static constexpr std::string_view kind = "harmonic_goursat";
};

template <class Kind, Scalar R>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Interpolating<R>>(cage, Kind::kind, options);
}

template <class Kind>
DeformMethod method(std::string_view source) {
  return {.name = Kind::kind,
          .source = source,
          .keeps = "affine maps",
          .kind = Kind::kind,
          .has_pose_derivative = true,
          .prepare = prepare<Kind, double>,
          .prepare_in_50_digits = prepare<Kind, Mp50>};
}

const RegisterDeformMethod mean_value{method<MeanValue>("Ju, Schaefer, Warren 2005, of triangulated cages")};
const RegisterDeformMethod quad_mean_value{method<QuadMeanValue>("[T18] Section 5")};
const RegisterDeformMethod spherical{method<SphericalMeanValue>("Langer, Belyaev, Seidel 2006")};
const RegisterDeformMethod entropy{method<MaximumEntropy>("Hormann, Sukumar 2008")};
const RegisterDeformMethod harmonic{method<Harmonic>("Joshi et al. 2007, by boundary elements")};
const RegisterDeformMethod true_harmonic{method<TrueHarmonic>("Joshi et al. 2007, by Goursat's functions")};

}  // namespace
}  // namespace cageproof::deformation
