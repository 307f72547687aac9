// SPDX-License-Identifier: MIT
// Integrals of s^j / r^(2p) along one straight line of a bilinear quad: elementary, in forms whose terms do not cancel.
#pragma once

#include "quad/engine/outer_rule.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/linear.h"

#include <array>
#include <cmath>

namespace cageproof::adaptive_qmvc {

/// gauss_legendre, remembered by each thread: it is asked for at every line.
template <Scalar R>
const GaussLegendre<R>& gauss_rule(int n) {
  thread_local std::array<const GaussLegendre<R>*, 512> rules{};
  if (n >= static_cast<int>(rules.size())) return gauss_legendre<R>(n);
  if (!rules[n]) rules[n] = &gauss_legendre<R>(n);
  return *rules[n];
}

/// Integrals over the line a + t e, t in [first, first + 1], about its point t = origin: the integral of s^j r^(-2p)
/// dt, s = t - origin, r = |a + t e|, for p = 2 (j <= 2), p = 3 (j <= 3, Order >= 1), p = 4 (j <= 4, Order >= 2).
template <class R>
struct LineMoments {
  R origin;
  std::array<R, 3> p2;
  std::array<R, 4> p3;
  std::array<R, 5> p4;
};

/// From ends that far away in sum on, in lengths of the line, a Gauss rule along it (ellipse of semi-axes' sum 4.79)
/// replaces the elementary integrals, which cancel with the distance.
inline constexpr double kFarAlongLine = 2.5;

/// Nodes along a line whose ends' distances sum up to `ends` lengths (>= 1), for `digits` digits of integrals of r^-4
/// with `order` derivatives: an integrand analytic inside the ellipse through its poles, of order 2 + order.
inline int nodes_along_line(double ends, int order, double digits) { return plain_nodes(ends, 2 + order, digits); }

/// K_n = int_0^1 x^(2n)/(1 + y x^2)^(n + 1) dx for n = 0 .. N: what atan leaves after n terms, all of them positive.
template <int N, class R>
std::array<R, N + 1> atan_remainders(const R& y, double digits) {
  using std::atan, std::sqrt;
  std::array<R, N + 1> k;
  const R e = 1 / (1 + y);
  if (y >= R(1)) {
    const R root = sqrt(y);
    k[0] = atan(root) / root;
    R power = e;
    for (int n = 0; n < N; ++n, power *= e) k[n + 1] = ((2 * n + 1) * k[n] - power) / (2 * (n + 1) * y);
    return k;
  }
  // Downwards K_n = e^(n+1) L_n, L_n = (1 + (n + 1) q L_(n+1))/(2n + 1): a wrong start dies out like (y/(1+y))^n.
  const R q = 2 * y * e;
  const double ratio = static_cast<double>(y) / (1 + static_cast<double>(y));
  const int start = N + 2 + (ratio > 1e-300 ? static_cast<int>(std::ceil((digits + 1) / -std::log10(ratio))) : 0);
  R l = R(1) / (2 * start + 1);
  std::array<R, N + 1> ls;
  for (int n = start - 1; n >= 0; --n) {
    l = (1 + (n + 1) * q * l) / (2 * n + 1);
    if (n <= N) ls[n] = l;
  }
  R power = e;
  for (int n = 0; n <= N; ++n, power *= e) k[n] = power * ls[n];
  return k;
}

/// Close to the line: about the foot of the perpendicular from the point, s = t.
/// \param area |a x e|^2
/// \param first, last t at the line's ends, one apart
template <int Order, class R>
LineMoments<R> moments_about_foot(const Vec3<R>& a, const Vec3<R>& e, const R& first, const R& last, const R& area,
                                  double digits) {
  using std::atan2, std::sqrt;
  const R length2 = e.dot(e);
  const R inverse = 1 / length2;
  const R to_foot = a.dot(e) * inverse, t0 = first + to_foot, t1 = last + to_foot;
  const R k2 = area * inverse * inverse;
  const R product = t0 * t1, d = k2 + product;
  const R r0 = t0 * t0 + k2, r1 = t1 * t1 + k2;
  const R both = 1 / (r0 * r1), i0 = both * r1, i1 = both * r0;
  LineMoments<R> m;
  m.origin = -to_foot;
  std::array<R, 5> zeroth;  // int t^0 (t^2 + k2)^-p
  // int dt/(t^2 + k2)^p, upwards in p where the foot is within the line or far off it, else as derivatives of
  // atan(k/d)/k by k2.
  if (product <= k2) {
    const R k = sqrt(k2), half = 1 / (2 * k2);
    zeroth[1] = atan2(k, d) / k;
    zeroth[2] = (zeroth[1] + (k2 - product) * both) * half;
    if constexpr (Order >= 1) zeroth[3] = (t1 * i1 * i1 - t0 * i0 * i0 + 3 * zeroth[2]) * half / 2;
    if constexpr (Order >= 2) zeroth[4] = (t1 * i1 * i1 * i1 - t0 * i0 * i0 * i0 + 5 * zeroth[3]) * half / 3;
  } else {
    const R v = 1 / d, v2 = v * v, v3 = v2 * v;
    const R y = k2 * v2;
    const auto h = atan_remainders<Order + 1>(y, digits);
    zeroth[1] = h[0] * v;
    zeroth[2] = both + h[1] * v3;
    if constexpr (Order >= 1) {
      const R c = 1 / (1 + y), slope = (product - k2) * v3;
      const R h2 = 2 * h[2];
      zeroth[3] = (2 * v3 * c + slope * v2 * c * c + 3 * h[1] * v2 * v2 + h2 * slope * v3) / 2;
      if constexpr (Order >= 2) {
        const R bend = v3 + 3 * slope * v, h3 = 6 * h[3];
        zeroth[4] = (6 * v2 * v2 * c + 4 * v3 * c * c * slope + bend * v2 * c * c + 2 * slope * slope * v2 * c * c * c +
                     6 * h2 * slope * v2 * v2 + 12 * h[1] * v2 * v3 + h3 * slope * slope * v3 + h2 * bend * v3) /
                    6;
      }
    }
  }
  const R difference = (t0 + t1) * both;  // 1/r0 - 1/r1
  const R scale2 = inverse * inverse;
  m.p2 = {zeroth[2] * scale2, difference / 2 * scale2, (zeroth[1] - (k2 - product) * both) / 2 * scale2};
  if constexpr (Order >= 1) {
    const R scale3 = scale2 * inverse;
    const R first3 = difference * (i0 + i1) / 4;
    m.p3 = {zeroth[3] * scale3, first3 * scale3, (zeroth[2] - (t1 * i1 * i1 - t0 * i0 * i0)) / 4 * scale3,
            (difference / 2 - k2 * first3) * scale3};
    if constexpr (Order >= 2) {
      const R scale4 = scale3 * inverse;
      const R c1 = i1 * i1 * i1, c0 = i0 * i0 * i0;
      const R first4 = difference * (i0 * i0 + both + i1 * i1) / 6;
      const R second3 = (zeroth[2] - (t1 * i1 * i1 - t0 * i0 * i0)) / 4;
      m.p4 = {zeroth[4] * scale4, first4 * scale4, (zeroth[3] - (t1 * c1 - t0 * c0)) / 6 * scale4,
              (first3 - k2 * first4) * scale4, (3 * second3 - (t1 * t1 * t1 * c1 - t0 * t0 * t0 * c0)) / 6 * scale4};
    }
  }
  return m;
}

/// Far from the line: Gauss-Legendre along it, about its middle. Its length may be zero.
template <int Order, class R>
LineMoments<R> moments_by_gauss(const Vec3<R>& a, const Vec3<R>& e, const R& first, const GaussLegendre<R>& rule) {
  LineMoments<R> m{};
  const R half = R(1) / 2;
  m.origin = first + half;
  const Vec3<R> middle = a + m.origin * e;
  const R c = middle.dot(middle), b = 2 * middle.dot(e), l = e.dot(e);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const R s = rule.nodes[i] - half;
    const R inverse = 1 / (c + s * (b + s * l));
    R f = rule.weights[i] * inverse * inverse;
    R term = f;
    for (int j = 0; j < 3; ++j, term *= s) m.p2[j] += term;
    if constexpr (Order >= 1) {
      f *= inverse;
      term = f;
      for (int j = 0; j < 4; ++j, term *= s) m.p3[j] += term;
    }
    if constexpr (Order >= 2) {
      f *= inverse;
      term = f;
      for (int j = 0; j < 5; ++j, term *= s) m.p4[j] += term;
    }
  }
  return m;
}

}  // namespace cageproof::adaptive_qmvc
