// SPDX-License-Identifier: MIT
// The weights' sums over lines, and how much of them cancels where a quad folds over.
#pragma once

#include "quad/engine/line_moments.h"
#include "quad/engine/local_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

namespace cageproof::adaptive_qmvc {

/// The type that holds sizes of sums: numbers whose exponents suit the scalar.
template <class R>
using Size = std::conditional_t<is_multiprecision<R> || std::same_as<R, long double>, long double, double>;

/// The weights' sums over lines: for each corner value, gradient, Hessian (xx, xy, xz, yy, yz, zz).
template <class R, int Order>
struct WeightSums {
  static constexpr int entries = Order == 0 ? 1 : Order == 1 ? 4 : 10;
  std::array<std::array<R, entries>, 4> corner{};
  bool watched = false;                        ///< whether `magnitude` is wanted
  std::array<Size<R>, Order + 1> magnitude{};  ///< for each order, what the sizes of its terms add up to
};

/// Adds the sizes of one line's terms, all basis functions together, whose sum is one.
/// \param s the line's step from the frame's
/// \param x the line's point at the moments' origin, and `e` its direction
template <int Order, class R>
void add_magnitudes(const LocalFrame<R>& q, const R& s, const R& weight, const LineMoments<R>& m, const Vec3<R>& x,
                    const Vec3<R>& e, WeightSums<R, Order>& sums) {
  using F = Size<R>;
  const auto size = [](const R& value) { return std::abs(static_cast<F>(value)); };
  const auto length = [](const Vec3<R>& v) { return std::sqrt(static_cast<F>(R(v.dot(v)))); };
  // Moments of |t|, from above.
  const auto odd = [&](const R& below, const R& above) { return std::sqrt(size(below)) * std::sqrt(size(above)); };
  const F lines = size(weight), step = size(s), along = size(m.origin);
  const F g1 = size(q.g10) + step * size(q.g11), g0 = size(q.g00) + step * size(q.g01) + along * g1;
  const F p0 = size(m.p2[0]), p1 = odd(m.p2[0], m.p2[2]);
  sums.magnitude[0] += lines * (g0 * p0 + g1 * p1);
  if constexpr (Order >= 1) {
    const F to = length(x), by = length(e);
    const F n1 = length(q.n_u), n0 = length(q.n) + step * length(q.n_v) + along * n1;
    const F q0 = size(m.p3[0]), q1 = odd(m.p3[0], m.p3[2]), q2 = size(m.p3[2]);
    const F h0 = g0 * q0 + g1 * q1, h1 = g0 * q1 + g1 * q2;
    sums.magnitude[1] += lines * (4 * (to * h0 + by * h1) + n0 * p0 + n1 * p1);
    if constexpr (Order >= 2) {
      const F r0 = size(m.p4[0]), r2 = size(m.p4[2]), r1 = odd(m.p4[0], m.p4[2]), r3 = odd(m.p4[2], m.p4[4]);
      const F k0 = 24 * (g0 * r0 + g1 * r1), k1 = 24 * (g0 * r1 + g1 * r2), k2 = 24 * (g0 * r2 + g1 * r3);
      sums.magnitude[2] += lines * (k0 * to * to + 2 * k1 * to * by + k2 * by * by +
                                    8 * (to * (q0 * n0 + q1 * n1) + by * (q1 * n0 + q2 * n1)) + 4 * h0);
    }
  }
}

/// How many times as large as the tensor of an order the sizes of its terms are: the largest over the orders, one
/// where there are no terms, infinite where nothing is left of them. \pre sums.watched
template <int Order, class R>
double cancellation(const WeightSums<R, Order>& sums) {
  using F = Size<R>;
  constexpr std::array<int, 4> begin{0, 1, 4, 10};
  double largest = 1;
  for (int o = 0; o <= Order; ++o) {
    F norm = 0;
    for (const auto& corner : sums.corner)
      for (int i = begin[o]; i < begin[o + 1]; ++i) norm = std::hypot(norm, static_cast<F>(corner[i]));
    if (sums.magnitude[o] == 0) continue;
    const auto ratio = static_cast<double>(sums.magnitude[o] / norm);
    largest = ratio >= 0 ? std::max(largest, ratio) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

}  // namespace cageproof::adaptive_qmvc
