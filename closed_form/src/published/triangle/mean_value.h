// SPDX-License-Identifier: MIT
// triangle.mean_value as [T18] prints it, after Ju, Schaefer and Warren 2005: angles, mean vector, edge normals.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <array>
#include <cmath>

namespace cageproof::closed_form::published {

/// w_t^k in the plane of the triangle, where Eq 14 divides by zero ([T18], below it): zero outside; within, where the
/// coordinates are the hat functions, infinite where these are positive, NaN where they are zero.
/// \param normals N_k, parallel to the triangle's normal
template <Scalar R>
std::array<R, 3> mean_value_in_plane(const Triangle<R>& t, const std::array<Vec3<R>, 3>& normals) {
  const Vec3<R> outward = Vec3<R>(t[1] - t[0]).cross(Vec3<R>(t[2] - t[0]));
  std::array<R, 3> w;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const R hat = -normals[k].dot(outward);
    inside = inside && hat >= 0;
    w[k] = hat > 0 ? std::numeric_limits<R>::infinity() : std::numeric_limits<R>::quiet_NaN();
  }
  if (!inside) w.fill(R(0));
  return w;
}

/// w_t^k = m.N_k/((t_k - eta).N_k), m = -sum theta_k N_k/(2 |N_k|), N_k = (t_{k+2} - eta) x (t_{k+1} - eta)
/// ([T18] Eq 12-14): 1/length. theta_k, the angle between t_{k+1} and t_{k+2} as eta sees them, is 2 asin(l/2), l the
/// distance of these two on the unit sphere (Ju et al. 2005, Section 4). Next to the triangle's plane m and N_k are
/// nearly orthogonal, and their product cancels.
template <Scalar R>
std::array<R, 3> mean_value(const Triangle<R>& t, const Vec3<R>& eta) {
  using std::asin;
  std::array<Vec3<R>, 3> arrow, unit, normals;
  for (int k = 0; k < 3; ++k) {
    arrow[k] = t[k] - eta;
    unit[k] = arrow[k] / arrow[k].norm();
  }
  Vec3<R> mean = Vec3<R>::Zero();
  std::array<R, 3> volumes;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    normals[k] = arrow[last].cross(arrow[next]);
    volumes[k] = arrow[k].dot(normals[k]);
    const R theta = 2 * asin(R(Vec3<R>(unit[last] - unit[next]).norm() / 2));
    mean -= normals[k] * R(theta / (2 * normals[k].norm()));
  }
  if (volumes[0] == 0 || volumes[1] == 0 || volumes[2] == 0) return mean_value_in_plane(t, normals);
  std::array<R, 3> w;
  for (int k = 0; k < 3; ++k) w[k] = mean.dot(normals[k]) / volumes[k];
  return w;
}

}  // namespace cageproof::closed_form::published
