// SPDX-License-Identifier: MIT
// Where a point is to a quad, as far as the weights are special there.
#pragma once

#include "quad/mean_value/riemann/linear_solution.h"
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <limits>

namespace cageproof::adaptive_qmvc {

/// On the quad the weights diverge; elsewhere in a planar quad's plane they are zero.
struct QuadContact {
  std::optional<BilinearPoint> on;
  bool in_plane = false;
};

/// Whether kappa may be a multiple of basis functions up to rounding: k_i of one sign, k_0 k_2 = k_1 k_3. So it is on
/// the quad.
template <Scalar R>
bool may_be_on_quad(const Vec4<R>& k) {
  using std::abs;
  // |p_i| < 2 in units: a determinant's error is a few times epsilon.
  const R noise = 64 * std::numeric_limits<R>::epsilon();
  if (k.minCoeff() < -noise && k.maxCoeff() > noise) return false;
  return abs(R(k[0] * k[2] - k[1] * k[3])) <= noise * (k.cwiseAbs().sum() + noise);
}

/// Whether the quad is planar and the point in its plane, exactly.
inline bool in_plane_of_planar(const Quad<double>& q, const Vec3<double>& point) {
  if (!is_planar(q)) return false;
  for (int i = 0; i < 4; ++i)
    if (side_of_plane({q[i], q[(i + 1) % 4], q[(i + 2) % 4]}, point) != 0) return false;
  return true;
}

/// Decided exactly for inputs that are doubles; others are taken to be at none of these places.
template <Scalar R>
QuadContact quad_contact(const Quad<R>& q, const Vec3<R>& point, const Vec4<R>& kappa) {
  if (!may_be_on_quad(kappa)) return {};
  Quad<double> corners;
  Vec3<double> eta;
  for (int c = 0; c < 3; ++c) {
    eta[c] = static_cast<double>(point[c]);
    if (R(eta[c]) != point[c]) return {};
    for (int i = 0; i < 4; ++i) {
      corners[i][c] = static_cast<double>(q[i][c]);
      if (R(corners[i][c]) != q[i][c]) return {};
    }
  }
  return {on_quad(corners, eta), in_plane_of_planar(corners, eta)};
}

}  // namespace cageproof::adaptive_qmvc
