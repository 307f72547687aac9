// SPDX-License-Identifier: MIT
// Layers of one quad at one point next to it, a vector of its lines at a time.
#pragma once

#include "line_moments.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

/// The lines p + s q.
inline Three along(const double* p, const Lanes& s, const double* q) {
  return {p[0] + s * q[0], p[1] + s * q[1], p[2] + s * q[2]};
}

inline double sum_of(const Lanes& x) {
  double sum = 0;
  for (int i = 0; i < kLanes; ++i) sum += x[i];
  return sum;
}

/// Everything is seen from the frame's own point, next to which what is small has its own digits.
template <bool Biharmonic>
void add_near_layers_of(const NearLines& lines, double* to) {
  constexpr int integrands = Biharmonic ? 4 : 2;
  const NearQuad& q = *lines.quad;
  Lanes sums[4 * integrands] = {};
  for (int first = 0; first < lines.count; first += kLanes) {
    const Lanes s = load(lines.step + first), weight = load(lines.weight + first);
    const Three e = along(q.e, s, q.w), start = along(q.a, s, q.b);
    const Three slope = along(q.c1, s, q.c2);
    const Three area{q.c0[0] + s * slope.x, q.c0[1] + s * slope.y, q.c0[2] + s * slope.z};
    const Lanes square = dot(e, e), over = reciprocal_root(square), over2 = over * over, length = square * over;
    const Lanes origin = dot(start, e) * over;  // of t, where u = u0
    const Lanes t0 = origin - q.u0 * length, t1 = origin + (1 - q.u0) * length;
    GrowingMoments growing{};
    const LineMoments m =
        moments_about(origin, t0, t1, dot(area, area) * over2, length, Biharmonic ? &growing : nullptr);
    const Lanes g0 = q.g00 + s * q.g01, g1 = (q.g10 + s * q.g11) * over;
    // Integrals of f and of (u - u0) f over u.
    const Lanes f[4] = {(g0 * m.cube + g1 * m.c1) * over, m.inverse * over, (g0 * m.inverse + g1 * m.step) * over,
                        growing.r * over};
    const Lanes f_u[4] = {(g0 * m.c1 + g1 * m.c2) * over2, m.step * over2, (g0 * m.step + g1 * growing.step2) * over2,
                          growing.step_r * over2};
    const Lanes right = (q.v0 + s) * weight, left = (1 - (q.v0 + s)) * weight;
    for (int i = 0; i < integrands; ++i) {
      const Lanes far = q.u0 * f[i] + f_u[i], near = (1 - q.u0) * f[i] - f_u[i];
      sums[4 * i] += left * near;
      sums[4 * i + 1] += left * far;
      sums[4 * i + 2] += right * far;
      sums[4 * i + 3] += right * near;
    }
  }
  for (int i = 0; i < 4 * integrands; ++i) to[i] += sum_of(sums[i]);
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
