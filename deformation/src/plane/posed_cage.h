// SPDX-License-Identifier: MIT
// Images by values at vertices and normal derivatives at edges that the method has found itself.
#pragma once

#include "../linear_posed.h"

namespace cageproof::deformation {

template <Scalar R>
class PosedCage final : public Posed<R> {
 public:
  PosedCage(const Matrix<R>& vertices, const Matrix<R>& normals, DeformationReport report)
      : linear_({vertices, normals}, std::move(report)) {}

  Images<R> images(std::span<const CoordinateTable<R>> coordinates, std::size_t points, int order) const override {
    return linear_.images(coordinates, points, order);
  }
  const DeformationReport& report() const override { return linear_.report(); }
  std::vector<Vec3<R>> vertices() const override {
    const Matrix<R>& rows = linear_.data()[0];
    std::vector<Vec3<R>> found;
    found.reserve(static_cast<std::size_t>(rows.rows()));
    for (Eigen::Index v = 0; v < rows.rows(); ++v) found.emplace_back(rows(v, 0), rows(v, 1), R(0));
    return found;
  }

 private:
  LinearPosed<R> linear_;
};

}  // namespace cageproof::deformation
