// SPDX-License-Identifier: MIT
// The derivative of rows of data by vertices, of which each row takes a few.
#pragma once

#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/numbers/least_squares.h"

#include <vector>

namespace cageproof::deformation {

/// A sparse matrix of 3 x 3 blocks. In the plane third numbers are zero.
template <Scalar R>
struct RowSlopes {
  struct Part {
    std::size_t row;
    int vertex;
    Mat3<R> slope;  ///< [of the row][by the vertex]
  };

  std::size_t rows = 0;
  std::vector<Part> parts = {};

  /// The change of rows along a change of vertices.
  std::vector<Vec3<R>> times(const std::vector<Vec3<R>>& change) const {
    std::vector<Vec3<R>> found(rows, Vec3<R>::Zero());
    for (const auto& [row, vertex, slope] : parts) found[row] += slope * change[vertex];
    return found;
  }

  /// Adds the transposed matrix times weights of rows, as many columns as the space has dimensions, to vertices.
  void add_transposed(const Matrix<R>& weights, std::vector<Vec3<R>>& vertices) const {
    const Eigen::Index d = weights.cols();
    for (const auto& [row, vertex, slope] : parts) {
      Vec3<R> weight = Vec3<R>::Zero();
      weight.head(d) = weights.row(static_cast<Eigen::Index>(row)).transpose();
      vertices[vertex] += slope.transpose() * weight;
    }
  }
  void add_transposed(const std::vector<Vec3<R>>& weights, std::vector<Vec3<R>>& vertices) const {
    for (const auto& [row, vertex, slope] : parts) vertices[vertex] += slope.transpose() * weights[row];
  }
};

}  // namespace cageproof::deformation
