// SPDX-License-Identifier: MIT
// The frame in a scalar's own arithmetic, from the nine coordinates: as a program or a shader without wider numbers can
// compute it.
#pragma once

#include "cageproof/closed_form/triangle/engine/frame.h"

namespace cageproof::closed_form::triangle {

/// Heights are taken from the nearest corner and divided last, so that their zeros and signs are exact where
/// coordinates are small integers. Lengths are the caller's.
template <class R>
Frame<R> plain_frame(const Triangle<R>& t, const Vec3<R>& eta) {
  using std::sqrt;
  Frame<R> f;
  std::array<Vec3<R>, 3> along;
  for (int i = 0; i < 3; ++i) {
    f.p[i] = t[i] - eta;
    f.r[i] = sqrt(f.p[i].dot(f.p[i]));
    along[i] = t[(i + 1) % 3] - t[i];
  }
  f.find_far_corner();
  const int nearest = f.r[0] <= f.r[1] && f.r[0] <= f.r[2] ? 0 : f.r[1] <= f.r[2] ? 1 : 2;
  const Vec3<R> normal = along[0].cross(along[1]);
  f.area2 = sqrt(normal.dot(normal));
  f.n = normal / f.area2;
  f.d = -normal.dot(f.p[nearest]) / f.area2;
  for (int i = 0; i < 3; ++i) {
    FrameEdge<R>& e = f.edges[i];
    const int j = (i + 1) % 3;
    const Vec3<R> outward = along[i].cross(normal);
    e.length = sqrt(along[i].dot(along[i]));
    e.u = along[i] / e.length;
    e.nu = outward / (e.length * f.area2);
    e.h = outward.dot(f.p[f.r[i] <= f.r[j] ? i : j]) / (e.length * f.area2);
    e.s0 = along[i].dot(f.p[i]) / e.length;
    e.s1 = along[i].dot(f.p[j]) / e.length;
    e.r0 = f.r[i];
    e.r1 = f.r[j];
    e.D2 = e.h * e.h + f.d * f.d;
  }
  return f;
}

}  // namespace cageproof::closed_form::triangle
