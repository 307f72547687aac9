// SPDX-License-Identifier: MIT
// Deformers by four layers, f = phi V' + psi N' + phibar L' + psibar D' ([T24] Eq 19), whose densities L' and D' are
// linear in V' and N'.
#pragma once

#include "../linear_pose_derivative.h"
#include "../normal_slopes.h"
#include "../posed_orientation.h"
#include "corner_normals.h"
#include "regularisation.h"
#include "similarities.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// The owner of normal derivatives, by the parameter `neumann`: constant (0), affine (1).
inline Owner normals_by(double neumann) { return neumann == 0 ? Owner::Element : Owner::Corner; }

/// The four layers of a cage, its quads kept.
inline CageCoordinates quad_layers_of(const Cage& cage, const DeformOptions& options) {
  return {cage, coordinate_kind_named("quad_biharmonic"),
          CoordinateOptions{options.evaluation, options.triangulation, {}}};
}

/// The four layers of a triangulated cage. \param normals what there is a normal derivative for: an element, or a
/// corner, between which they are affine ([T24] Eq 41-43)
inline CageCoordinates layers_of(const Cage& cage, const DeformOptions& options, Owner normals = Owner::Element) {
  return {cage, coordinate_kind_named(normals == Owner::Corner ? "biharmonic_affine" : "biharmonic"),
          CoordinateOptions{options.evaluation, options.triangulation, {}}};
}

template <Scalar R>
class LayerDeformer : public Deformer<R> {
 public:
  explicit LayerDeformer(CageCoordinates layers) : coordinates_(std::move(layers)) {}

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return {regularisation_.solved, {}, regularisation_.warnings}; }

 protected:
  Owner normals_of() const { return normals_owner(coordinates_); }
  /// Posed normals that the method has where the pose prescribes none, a row each of normals_of().
  std::vector<Vec3<R>> own_normals(Stretch stretch, const std::vector<Vec3<R>>& vertices,
                                   DeformationReport& report) const {
    const CageElements& elements = coordinates_.elements();
    warn_of_orientation(elements, vertices, report.warnings);
    return normals_of() == Owner::Corner ? corner_normals(stretch, elements, vertices, report.warnings)
                                         : stretched_normals(stretch, elements, vertices);
  }
  /// The derivatives of own_normals() by the pose's vertices; zeros where the pose prescribes normals.
  RowSlopes<R> normal_slopes_at(Stretch stretch, const Pose<R>& pose) const {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose, normals_of());
    if (!pose.normal_derivatives.empty()) return {.rows = pose.normal_derivatives.size()};
    return normals_of() == Owner::Corner ? corner_normal_slopes(stretch, elements, pose.vertices)
                                         : stretched_normal_slopes(stretch, elements, pose.vertices);
  }
  void regularise(Regularisation<R> found) {
    regularisation_ = std::move(found);
    const std::vector<Vec3<R>> rest = vertices_in<R>(coordinates_.elements());
    const int d = coordinates_.dimension();
    DeformationReport of_rest;
    similarities_ = {rows_of(rest, d), rows_of(own_normals(Stretch::Unit, rest, of_rest), d)};
  }
  const Regularisation<R>& regularisation() const { return regularisation_; }

  /// The rest cage under the similarity next to the pose. Its densities, and its second derivatives, are
  /// zero by what layers are. Sums of layers give zero only up to their roundings, which a system's condition
  /// multiplies. So a method asks its system only for the difference between the pose and this, and rigid poses keep
  /// their digits.
  Similar<R> similar_to(const Matrix<R>& posed) const { return similarities_.next_to(posed); }

  /// The pose with these normal derivatives, a row each of normals_of().
  std::unique_ptr<const Posed<R>> with(const Matrix<R>& vertices, const Matrix<R>& normals, const Similar<R>& similar,
                                       DeformationReport report) const {
    const Matrix<R> densities = regularisation_.to_vertices * (vertices - similar.vertices) +
                                regularisation_.to_normals * (normals - similar.normals);
    const Eigen::Index n = vertices.rows();
    return std::make_unique<LinearPosed<R>>(
        std::vector<Matrix<R>>{vertices, normals, densities.topRows(n), densities.bottomRows(densities.rows() - n)},
        std::move(report));
  }

 private:
  CageCoordinates coordinates_;
  Regularisation<R> regularisation_;
  Similarities<R> similarities_;
};

}  // namespace cageproof::deformation
