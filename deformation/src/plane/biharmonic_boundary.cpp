// SPDX-License-Identifier: MIT
// Deformation of the plane by biharmonic functions that are solved for: f = alpha F + beta d ([W12] Section 5.1
// to 5.3).
#include "../layers/samples.h"
#include "../linear_pose_derivative.h"
#include "../normal_slopes.h"
#include "../posed_orientation.h"
#include "../stretches.h"
#include "solved_systems.h"

#include "cageproof/deformation/stretch.h"

#include <algorithm>
#include <span>

namespace cageproof::deformation {
namespace {

// The outward normal derivatives: posed unit normals (5.1), these times the stretches of edges, which make the map a
// complex one (5.2), or times factors that make Laplacians at the boundary's nodes least (5.3, as harmonic as
// possible).
enum class BoundaryNormals { Unit, Complex, LeastLaplacians };

template <Scalar R>
class BiharmonicBoundary final : public Deformer<R> {
 public:
  BiharmonicBoundary(const Cage& cage, const DeformOptions& options)
      : coordinates_(
            cage, coordinate_kind_named("biharmonic_boundary"),
            CoordinateOptions{
                options.evaluation, options.triangulation, {options.parameters.begin() + 1, options.parameters.end()}}),
        of_coordinates_(options.parameters.begin() + 1, options.parameters.end()),
        normals_(static_cast<BoundaryNormals>(static_cast<int>(options.parameters[0]))) {
    const std::vector<CoordinateTable<R>> laplacians = coordinates_.boundary_laplacians<R>();
    const std::size_t nodes = laplacians[0].tensors[0].size() / laplacians[0].stride[0];
    of_vertices_ = component(laplacians[0], nodes, 0, 1, 0);
    of_normals_ = component(laplacians[1], nodes, 0, 1, 0);
  }

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    if (!std::ranges::equal(std::span(parameters).subspan(1), of_coordinates_)) return nullptr;
    auto other = std::make_shared<BiharmonicBoundary>(*this);
    other->normals_ = static_cast<BoundaryNormals>(static_cast<int>(parameters[0]));
    return other;
  }

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return report_on(coordinates_); }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose);
    DeformationReport report;
    if (pose.normal_derivatives.empty()) warn_of_orientation(elements, pose.vertices, report.warnings);
    const Matrix<R> vertices = rows_of(pose.vertices, 2), fixed = of_vertices_ * vertices;
    Matrix<R> normals;
    if (!pose.normal_derivatives.empty()) {
      normals = rows_of(pose.normal_derivatives, 2);
    } else if (normals_ == BoundaryNormals::LeastLaplacians) {
      const Matrix<R> units = rows_of(stretched_normals(Stretch::Unit, elements, pose.vertices), 2);
      normals = least_stretched<R>(of_normals_, fixed, units, Matrix<R>::Zero(units.rows(), 1), true, report);
    } else {
      // Edges without length have no share in complex maps, and no normal.
      const Stretch stretch = normals_ == BoundaryNormals::Unit ? Stretch::Unit : Stretch::Area;
      normals = rows_of(stretched_normals(stretch, elements, pose.vertices), 2);
    }
    report.figures.emplace_back("sum of squared Laplacians",
                                static_cast<double>(R((fixed + of_normals_ * normals).squaredNorm())));
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{vertices, normals}, std::move(report));
  }
  // Normals of least Laplacians are those of a system whose matrix depends on the pose.
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose);
    const bool prescribes = !pose.normal_derivatives.empty();
    if (!prescribes && normals_ == BoundaryNormals::LeastLaplacians) return nullptr;
    const Stretch stretch = normals_ == BoundaryNormals::Unit ? Stretch::Unit : Stretch::Area;
    return std::make_unique<LinearPoseDerivative<R>>(2, pose.vertices.size(),
                                                     prescribes
                                                         ? RowSlopes<R>{.rows = pose.normal_derivatives.size()}
                                                         : stretched_normal_slopes(stretch, elements, pose.vertices));
  }

 private:
  CageCoordinates coordinates_;
  std::vector<double> of_coordinates_;  // parameters
  BoundaryNormals normals_;
  Matrix<R> of_vertices_, of_normals_;  // of Laplacians at nodes
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_boundary(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<BiharmonicBoundary<R>>(cage, options);
}

const RegisterDeformMethod biharmonic_boundary{
    {.name = "biharmonic_boundary",
     .source = "[W12] Sections 4 and 5.1 to 5.3, after the errata",
     .keeps = "rigid maps (normals=complex, ahap: similarities)",
     .kind = "biharmonic_boundary",
     .parameters = {{{.name = "normals", .preset = 0, .lowest = -1, .highest = 3, .whole = true},
                     "how long posed normals are: one, as edges are stretched, or as harmonic as possible",
                     {"unit", "complex", "ahap"}}},
     .takes_normal_derivatives = true,
     .has_pose_derivative = true,
     .prepare = prepare_boundary<double>,
     .prepare_in_50_digits = prepare_boundary<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
