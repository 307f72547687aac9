// SPDX-License-Identifier: MIT
// Deformers by four layers, f = phi V' + psi N' + phibar L' + psibar D' ([T24] Eq 19), whose densities L' and D' are
// linear in V' and N'.
#pragma once

#include "../linear_posed.h"
#include "../posed_orientation.h"
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

}  // namespace cageproof::deformation
