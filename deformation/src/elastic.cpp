// SPDX-License-Identifier: MIT
// Deformation as linear elasticity has it: the displacements of the posed cage, by matrices that solve for the
// tractions ([C23] Sections 3 and 4.2).
#include "matrix_posed.h"
#include "plane/solved_systems.h"

#include "cageproof/core/numbers/linear.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {
namespace {

// The map is linear.
template <Scalar R>
class ElasticDerivative final : public PoseDerivative<R> {
 public:
  ElasticDerivative(int dimension, std::size_t vertices)
      : dimension_(dimension), vertices_(static_cast<Eigen::Index>(vertices)) {}

  std::unique_ptr<const Posed<R>> along(const std::vector<Vec3<R>>& change) const override {
    return std::make_unique<MatrixPosed<R>>(std::vector<Matrix<R>>{rows_of(change, dimension_)});
  }
  std::vector<Matrix<R>> nothing() const override { return {Matrix<R>::Zero(vertices_, dimension_)}; }
  void gather(std::span<const CoordinateTable<R>> coordinates, std::size_t points, std::span<const R> weights,
              std::vector<Matrix<R>>& gathered) const override {
    const CoordinateTable<R>& table = coordinates[0];
    for (std::size_t p = 0; p < points; ++p) {
      const R* from = &table.tensors[0][p * table.stride[0]];
      for (Eigen::Index v = 0; v < vertices_; ++v)
        for (int row = 0; row < dimension_; ++row)
          for (int column = 0; column < dimension_; ++column)
            gathered[0](v, column) += *from++ * weights[static_cast<std::size_t>(dimension_) * p + row];
    }
  }
  std::vector<Vec3<R>> back(const std::vector<Matrix<R>>& gathered) const override {
    std::vector<Vec3<R>> found(static_cast<std::size_t>(vertices_), Vec3<R>::Zero());
    for (Eigen::Index v = 0; v < vertices_; ++v)
      for (int column = 0; column < dimension_; ++column) found[v][column] = gathered[0](v, column);
    return found;
  }

 private:
  int dimension_;
  Eigen::Index vertices_;
};

template <Scalar R>
class Elastic final : public Deformer<R> {
 public:
  Elastic(const Cage& cage, const DeformOptions& options)
      : coordinates_(cage, coordinate_kind_named("elastic"),
                     CoordinateOptions{options.evaluation, options.triangulation, options.parameters}) {}

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override { return report_on(coordinates_); }
  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    // x' = sum E_i v'_i: what displacements would give, because E keeps positions.
    return std::make_unique<MatrixPosed<R>>(std::vector<Matrix<R>>{rows_of(pose.vertices, coordinates_.dimension())});
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    return std::make_unique<ElasticDerivative<R>>(coordinates_.dimension(), pose.vertices.size());
  }

 private:
  CageCoordinates coordinates_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_elastic(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Elastic<R>>(cage, options);
}

const RegisterDeformMethod elastic{{.name = "elastic",
                                    .source = "[C23] Sections 3 and 4.2, by boundary elements",
                                    .keeps = "affine maps",
                                    .kind = "elastic",
                                    .has_pose_derivative = true,
                                    .prepare = prepare_elastic<double>,
                                    .prepare_in_50_digits = prepare_elastic<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
