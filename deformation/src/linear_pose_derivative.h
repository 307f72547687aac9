// SPDX-License-Identifier: MIT
// The derivative of poses whose data are vertices, normals, and densities that are linear in both.
#pragma once

#include "linear_posed.h"
#include "row_slopes.h"

#include <optional>

namespace cageproof::deformation {

/// Adds each block's transposed coordinates times the weights of images: one row per coordinate.
template <Scalar R>
void gather_rows(std::span<const CoordinateTable<R>> coordinates, std::size_t points, std::span<const R> weights,
                 std::vector<Matrix<R>>& gathered) {
  using Rows = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto count = static_cast<Eigen::Index>(points);
  const Eigen::Map<const Rows> of_images(weights.data(), count, gathered[0].cols());
  for (std::size_t b = 0; b < gathered.size(); ++b)
    gathered[b].noalias() +=
        Eigen::Map<const Rows>(coordinates[b].tensors[0].data(), count, gathered[b].rows()).transpose() * of_images;
}

/// Densities (L'; D') = to_vertices V' + to_normals N'; they are somebody else's.
template <Scalar R>
struct DensityMaps {
  const Matrix<R>&to_vertices, &to_normals;
};

/// Blocks of coordinates multiply V', N' and, where there are, L' and D'.
template <Scalar R>
class LinearPoseDerivative final : public PoseDerivative<R> {
 public:
  /// \param normals by vertices; without rows where the pose has no normals
  LinearPoseDerivative(int dimension, std::size_t vertices, RowSlopes<R> normals,
                       std::optional<DensityMaps<R>> densities = std::nullopt)
      : dimension_(dimension), vertices_(vertices), normals_(std::move(normals)), densities_(densities) {}

  std::unique_ptr<const Posed<R>> along(const std::vector<Vec3<R>>& change) const override {
    std::vector<Matrix<R>> data{rows_of(change, dimension_)};
    if (normals_.rows > 0) data.push_back(rows_of(normals_.times(change), dimension_));
    if (densities_) {
      const Matrix<R> both = densities_->to_vertices * data[0] + densities_->to_normals * data[1];
      data.emplace_back(both.topRows(data[0].rows()));
      data.emplace_back(both.bottomRows(both.rows() - data[0].rows()));
    }
    return std::make_unique<LinearPosed<R>>(std::move(data), DeformationReport());
  }

  std::vector<Matrix<R>> nothing() const override {
    const auto n = static_cast<Eigen::Index>(vertices_);
    std::vector<Matrix<R>> found{Matrix<R>::Zero(n, dimension_)};
    if (normals_.rows > 0) found.push_back(Matrix<R>::Zero(static_cast<Eigen::Index>(normals_.rows), dimension_));
    if (densities_) {
      found.push_back(Matrix<R>::Zero(n, dimension_));
      found.push_back(Matrix<R>::Zero(densities_->to_vertices.rows() - n, dimension_));
    }
    return found;
  }

  void gather(std::span<const CoordinateTable<R>> coordinates, std::size_t points, std::span<const R> weights,
              std::vector<Matrix<R>>& gathered) const override {
    gather_rows(coordinates, points, weights, gathered);
  }

  std::vector<Vec3<R>> back(const std::vector<Matrix<R>>& gathered) const override {
    Matrix<R> vertices = gathered[0];
    Matrix<R> normals = normals_.rows > 0 ? gathered[1] : Matrix<R>();
    if (densities_) {
      Matrix<R> both(gathered[2].rows() + gathered[3].rows(), dimension_);
      both << gathered[2], gathered[3];
      vertices += densities_->to_vertices.transpose() * both;
      normals += densities_->to_normals.transpose() * both;
    }
    std::vector<Vec3<R>> found(vertices_, Vec3<R>::Zero());
    for (std::size_t v = 0; v < vertices_; ++v)
      found[v].head(dimension_) = vertices.row(static_cast<Eigen::Index>(v)).transpose();
    if (normals_.rows > 0) normals_.add_transposed(normals, found);
    return found;
  }

 private:
  int dimension_;
  std::size_t vertices_;
  RowSlopes<R> normals_;
  std::optional<DensityMaps<R>> densities_;
};

}  // namespace cageproof::deformation
