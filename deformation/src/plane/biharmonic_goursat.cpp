// SPDX-License-Identifier: MIT
// Deformation of the plane by the true biharmonic functions of a polygon: f = alpha F + beta d ([W12] Sections 5.1 and
// 5.2). A scheme of boundary elements misses normal derivatives by tenths (biharmonic_boundary).
#include "../linear_pose_derivative.h"
#include "../normal_slopes.h"
#include "../posed_orientation.h"
#include "solved_systems.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class BiharmonicGoursat final : public Deformer<R> {
 public:
  BiharmonicGoursat(const Cage& cage, const DeformOptions& options)
      : coordinates_(cage, coordinate_kind_named("biharmonic_goursat"),
                     CoordinateOptions{options.evaluation, options.triangulation, {}}),
        stretch_(stretch_of(options.parameters)) {}

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = std::make_shared<BiharmonicGoursat>(*this);
    other->stretch_ = stretch_of(parameters);
    return other;
  }

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return report_on_true(coordinates_); }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose);
    DeformationReport report;
    const bool prescribes = !pose.normal_derivatives.empty();
    if (!prescribes) warn_of_orientation(elements, pose.vertices, report.warnings);
    const Matrix<R> normals =
        rows_of(prescribes ? pose.normal_derivatives : stretched_normals(stretch_, elements, pose.vertices), 2);
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{rows_of(pose.vertices, 2), normals},
                                            std::move(report));
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose);
    return std::make_unique<LinearPoseDerivative<R>>(2, pose.vertices.size(),
                                                     pose.normal_derivatives.empty()
                                                         ? stretched_normal_slopes(stretch_, elements, pose.vertices)
                                                         : RowSlopes<R>{.rows = pose.normal_derivatives.size()});
  }

 private:
  // Posed unit normals (5.1), or these times the stretches of edges, which make the map a complex one (5.2); edges
  // without length have no share in it, and no normal.
  static Stretch stretch_of(const std::vector<double>& parameters) {
    return parameters[0] == 0 ? Stretch::Unit : Stretch::Area;
  }

  CageCoordinates coordinates_;
  Stretch stretch_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_true(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<BiharmonicGoursat<R>>(cage, options);
}

const RegisterDeformMethod biharmonic_goursat{
    {.name = "biharmonic_goursat",
     .source = "[W12] Sections 5.1 and 5.2, by Goursat's functions",
     .keeps = "rigid maps (normals=complex: similarities)",
     .kind = "biharmonic_goursat",
     .parameters = {{{.name = "normals", .preset = 0, .lowest = -1, .highest = 2, .whole = true},
                     "how long posed normals are: one, or as edges are stretched",
                     {"unit", "complex"}}},
     .takes_normal_derivatives = true,
     .has_pose_derivative = true,
     .prepare = prepare_true<double>,
     .prepare_in_50_digits = prepare_true<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
