// SPDX-License-Identifier: MIT
// The Riemann sum of a quad's mean value weights on a grid that follows the point ([T18] Section 3.4.3, Eq 22-23).
#pragma once

#include "quad/mean_value/riemann/linear_solution.h"

#include <vector>

namespace cageproof::adaptive_qmvc {

/// 2n + 1 parameters with `centre` in the middle, and the lengths of their Voronoi cells, whose sum is 1. Padded with
/// empty cells to a multiple of four.
template <Scalar R>
struct GridLine {
  std::vector<R> at, length;
  int count = 0;  ///< without padding

  void place(int n, const R& centre) {
    count = 2 * n + 1;
    const std::size_t padded = static_cast<std::size_t>(count + 3) / 4 * 4;
    at.resize(padded, R(0));
    length.resize(padded, R(0));
    const R below = centre / R(n), above = (1 - centre) / R(n);
    for (int k = 0; k < n; ++k) {
      at[k] = below * R(k);
      at[n + 1 + k] = k + 1 == n ? R(1) : centre + above * R(k + 1);
      length[k] = k == 0 ? R(below / 2) : below;
      length[n + 1 + k] = k + 1 == n ? R(above / 2) : above;
    }
    at[n] = centre;
    length[n] = (below + above) / 2;
    for (std::size_t k = count; k < padded; ++k) at[k] = centre, length[k] = R(0);
  }
};

/// The memory of one sum, kept from one to the next.
template <Scalar R>
struct RiemannWorkspace {
  GridLine<R> u, v;
  std::vector<R> column, rising;  ///< by u: the sums over v of the kernel, and of v times the kernel
};

/// Adds one row, v fixed, to the sums of every column. (a, e): the row's start and extent; g0 + u slope: N.x, which is
/// linear along it.
template <class R>
void add_row(const R* __restrict u, int padded, const Vec3<R>& a, const Vec3<R>& e, const R& g0, const R& slope,
             const R& v, const R& length, R* __restrict column, R* __restrict rising) {
  const R &ax = a[0], &ay = a[1], &az = a[2], &ex = e[0], &ey = e[1], &ez = e[2], &base = g0, &step = slope,
          &height = v, &cell = length;
  for (int k = 0; k < padded; ++k) {
    const R x = ax + u[k] * ex, y = ay + u[k] * ey, z = az + u[k] * ez;
    const R square = x * x + y * y + z * z;
    const R term = cell * (base + u[k] * step) / (square * square);
    column[k] += term;
    rising[k] += height * term;
  }
}

/// Omega of Eq 22, in 1/unit, about the parameters (u, v). Not finite when a sample is at the point.
template <Scalar R>
Vec4<R> omega(const PairFrame<R>& s, int n, const R& u, const R& v, RiemannWorkspace<R>& work) {
  work.u.place(n, u);
  work.v.place(n, v);
  const int padded = static_cast<int>(work.u.at.size());
  work.column.assign(padded, R(0));
  work.rising.assign(padded, R(0));
  const Vec3<R>&left = s.along[k03], &right = s.along[k12], twist = right - left;
  for (int l = 0; l < work.v.count; ++l) {
    const R& height = work.v.at[l];
    const Vec3<R> a = s.p[0] + height * left, e = s.along[k01] + height * twist;
    const R g0 = a.dot(e.cross(left)), g1 = a.dot(e.cross(right));
    add_row<R>(work.u.at.data(), padded, a, e, g0, g1 - g0, height, work.v.length[l], work.column.data(),
               work.rising.data());
  }
  Vec4<R> sum = Vec4<R>::Zero();
  for (int k = 0; k < work.u.count; ++k) {
    const R to_right = work.u.at[k] * work.u.length[k], to_left = (1 - work.u.at[k]) * work.u.length[k];
    const R low = work.column[k] - work.rising[k], high = work.rising[k];
    sum += Vec4<R>(to_left * low, to_right * low, to_right * high, to_left * high);
  }
  return sum;
}

}  // namespace cageproof::adaptive_qmvc
