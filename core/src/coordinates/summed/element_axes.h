// SPDX-License-Identifier: MIT
// A flat element seen along itself.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <cmath>
#include <vector>

namespace cageproof {

/// The axes of a segment or triangle. One is along its first edge, one to the left of that edge (in the triangle's
/// plane, or in the plane of the segment's polygon), and, for a triangle, its normal.
template <Scalar R>
class ElementAxes {
 public:
  /// \pre a segment or triangle with length or area
  explicit ElementAxes(const std::vector<Vec3<R>>& corners) : origin_(corners[0]), dim_(corners.size() == 2 ? 2 : 3) {
    const Vec3<R> edge = corners[1] - corners[0];
    axes_[0] = unit(edge);
    if (dim_ == 2) {
      axes_[1] = {-axes_[0][1], axes_[0][0], R(0)};
      axes_[2] = {R(0), R(0), R(1)};
    } else {
      const Vec3<R> other = corners[2] - corners[0];
      axes_[2] = unit(Vec3<R>(edge.cross(other)));
      axes_[1] = axes_[2].cross(axes_[0]);
    }
    for (const Vec3<R>& corner : corners) {
      const Vec3<R> step = corner - origin_;
      corners_.push_back({axes_[0].dot(step), axes_[1].dot(step), R(0)});
    }
    // The first edge is the first axis, exactly.
    corners_[0] = Vec3<R>::Zero();
    corners_[1][1] = 0;
  }

  /// The corners there, at height zero.
  const std::vector<Vec3<R>>& corners() const { return corners_; }

  Vec3<R> in_space(const Vec3<R>& p) const { return origin_ + p[0] * axes_[0] + p[1] * axes_[1] + p[2] * axes_[2]; }

  /// Derivatives along these axes become those along the axes of space.
  void turn_to_space(int order, Result<R>& result) const {
    const std::size_t numbers = result.value.size();
    for (std::size_t i = 0; order >= 1 && i < numbers; ++i) {
      Vec3<R> turned = Vec3<R>::Zero();
      for (int a = 0; a < dim_; ++a) turned += result.gradient[i * dim_ + a] * axes_[a];
      for (int c = 0; c < dim_; ++c) result.gradient[i * dim_ + c] = turned[c];
    }
    const std::size_t width = static_cast<std::size_t>(dim_) * dim_;
    for (std::size_t i = 0; order >= 2 && i < numbers; ++i) {
      std::array<R, 9> turned{};
      for (int a = 0; a < dim_; ++a)
        for (int b = 0; b < dim_; ++b)
          for (int c = 0; c < dim_; ++c)
            for (int d = 0; d < dim_; ++d)
              turned[c * dim_ + d] += axes_[a][c] * axes_[b][d] * result.hessian[i * width + a * dim_ + b];
      for (std::size_t k = 0; k < width; ++k) result.hessian[i * width + k] = turned[k];
    }
  }

 private:
  static Vec3<R> unit(const Vec3<R>& v) {
    using std::sqrt;
    const R largest = v.cwiseAbs().maxCoeff();
    const Vec3<R> scaled = v / largest;
    return scaled / R(sqrt(R(scaled.dot(scaled))));
  }

  Vec3<R> origin_;
  int dim_;
  std::array<Vec3<R>, 3> axes_;
  std::vector<Vec3<R>> corners_;
};

}  // namespace cageproof
