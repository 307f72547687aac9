// SPDX-License-Identifier: MIT
// Deformers by four layers, f = phi V' + psi N' + phibar L' + psibar D' ([T24] Eq 19), whose densities L' and D' are
// linear in V' and N'.
#pragma once

#include "../linear_posed.h"
#include "regularisation.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

template <Scalar R>
class LayerDeformer : public Deformer<R> {
 public:
  LayerDeformer(const Cage& cage, const DeformOptions& options)
      : coordinates_(cage, coordinate_kind_named("biharmonic"),
                     CoordinateOptions{options.evaluation, options.triangulation, {}}) {}

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return {regularisation_.solved, {}, regularisation_.warnings}; }

 protected:
  void regularise(Regularisation<R> found) { regularisation_ = std::move(found); }
  const Regularisation<R>& regularisation() const { return regularisation_; }

  /// The pose with these normal derivatives, a row an element.
  std::unique_ptr<const Posed<R>> with(const Matrix<R>& vertices, const Matrix<R>& normals,
                                       DeformationReport report) const {
    const Matrix<R> densities = regularisation_.to_vertices * vertices + regularisation_.to_normals * normals;
    const Eigen::Index n = vertices.rows();
    return std::make_unique<LinearPosed<R>>(
        std::vector<Matrix<R>>{vertices, normals, densities.topRows(n), densities.bottomRows(normals.rows())},
        std::move(report));
  }

 private:
  CageCoordinates coordinates_;
  Regularisation<R> regularisation_;
};

/// Of a surface: warnings of a posed cage whose volume is negative.
template <Scalar R>
void warn_of_orientation(const CageElements& elements, const std::vector<Vec3<R>>& vertices,
                         std::vector<std::string>& warnings) {
  R volume = 0;
  const Vec3<R> about = vertices[0];
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    const Vec3<R> u = vertices[corners[0]] - about, v = vertices[corners[1]] - about;
    volume +=
        corners.size() == 2 ? R(u[0] * v[1] - u[1] * v[0]) : R(u.dot(v.cross(Vec3<R>(vertices[corners[2]] - about))));
  }
  if (volume < 0)
    warnings.emplace_back("the posed cage is inside out: its normals point inward, and mirror images are not kept");
}

}  // namespace cageproof::deformation
