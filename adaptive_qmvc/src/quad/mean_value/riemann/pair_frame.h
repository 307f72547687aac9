// SPDX-License-Identifier: MIT
// A quad as a point sees it: corners relative to the point, and what every step of the scheme needs of their pairs.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <cmath>

namespace cageproof::adaptive_qmvc {

/// The six pairs of corners: the edges 01, 12, 23, 03, then the diagonals 02, 13.
inline constexpr std::array<std::array<int, 2>, 6> kPairs{{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}, {1, 3}}};
/// Names of the pairs above.
enum Pair { k01, k12, k23, k03, k02, k13 };

/// A power of two not far above the largest distance of a corner along an axis: dividing by it changes no digit.
template <Scalar R>
R binary_unit(const Quad<R>& p) {
  using std::abs, std::frexp, std::ldexp, std::max;
  R largest = 0;
  for (const Vec3<R>& x : p)
    for (int c = 0; c < 3; ++c) largest = max(largest, R(abs(x[c])));
  if (!(largest > 0)) return R(1);
  int exponent = 0;
  (void)frexp(largest, &exponent);
  return ldexp(R(1), exponent);
}

/// Everything in `unit` lengths, so that the sixth powers of Eq 28 neither overflow nor vanish.
template <Scalar R>
struct PairFrame {
  R unit;                        ///< a power of two
  Quad<R> p;                     ///< q_i - eta
  std::array<Vec3<R>, 6> along;  ///< q_b - q_a of each pair, from the corners: near them p_b - p_a would lose it
  std::array<Vec3<R>, 6> cross;  ///< p_a x p_b of each pair
  std::array<Vec3<R>, 6>
      normal;  ///< angle(a eta b) p_a x p_b / (2 |p_a x p_b|): the mean vector of the pair's circular sector

  PairFrame(const Quad<R>& q, const Vec3<R>& eta) {
    for (int i = 0; i < 4; ++i) p[i] = q[i] - eta;
    unit = binary_unit(p);
    for (Vec3<R>& x : p) x /= unit;
    for (int k = 0; k < 6; ++k) along[k] = (q[kPairs[k][1]] - q[kPairs[k][0]]) / unit;
    see();
  }

  /// The same quad from a point `by` away, in units.
  PairFrame moved(const Vec3<R>& by) const {
    PairFrame other(*this);
    for (Vec3<R>& x : other.p) x -= by;
    other.see();
    return other;
  }

 private:
  // The angle by atan2 of sine and cosine, stable for all; a zero sine leaves the sector without a plane, and is given
  // none.
  void see() {
    using std::atan2, std::sqrt;
    std::array<R, 4> square;
    for (int i = 0; i < 4; ++i) square[i] = p[i].squaredNorm();
    for (int k = 0; k < 6; ++k) {
      const auto [a, b] = kPairs[k];
      // a x b = a x (b - a) = b x (b - a): of both the nearer corner keeps more digits.
      cross[k] = p[square[a] <= square[b] ? a : b].cross(along[k]);
      const R sine = sqrt(R(cross[k].squaredNorm()));
      normal[k] =
          sine > 0 ? Vec3<R>(cross[k] * (atan2(sine, R(p[a].dot(p[b]))) / (2 * sine))) : Vec3<R>(Vec3<R>::Zero());
    }
  }
};

}  // namespace cageproof::adaptive_qmvc
