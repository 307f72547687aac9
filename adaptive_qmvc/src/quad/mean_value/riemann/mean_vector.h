// SPDX-License-Identifier: MIT
// Mean vectors: integrals of the unit vectors from a point towards a surface. They depend only on the surface's border.
#pragma once

#include "quad/mean_value/riemann/pair_frame.h"

namespace cageproof::adaptive_qmvc {

/// m_q of [T18] Eq 16, without unit: int N.x x / r^4. Sides whose line passes through the point, and repeated corners,
/// count nothing.
template <Scalar R>
Vec3<R> mean_vector(const PairFrame<R>& s) {
  return s.normal[k01] + s.normal[k12] + s.normal[k23] - s.normal[k03];
}

/// The mean vectors of the quad's hull's faces (Eq 13), each oriented as the quad: 013, 123, 012, 023. Those of 013 and
/// 123 add up to m_q, and so do the two others'.
template <Scalar R>
std::array<Vec3<R>, 4> face_mean_vectors(const PairFrame<R>& s) {
  return {s.normal[k01] + s.normal[k13] - s.normal[k03], s.normal[k12] + s.normal[k23] - s.normal[k13],
          s.normal[k01] + s.normal[k12] - s.normal[k02], s.normal[k02] + s.normal[k23] - s.normal[k03]};
}

}  // namespace cageproof::adaptive_qmvc
