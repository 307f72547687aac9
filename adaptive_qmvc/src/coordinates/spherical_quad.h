// SPDX-License-Identifier: MIT
// A quad's share of spherical mean value coordinates (Langer, Belyaev, Seidel 2006; [T18] Section 5): its mean vector
// in mean value coordinates on the sphere. For plain numbers, or for numbers that carry derivatives by the point.
#pragma once

#include "quad/engine/line_moments.h"
#include "cageproof/core/geometry/element.h"
#include "cageproof/core/numbers/second_order.h"

#include <array>
#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc {

/// A vector of numbers N: of R, or of SecondOrder<R>.
template <class N>
using Vector = std::array<N, 3>;
template <class N>
using CornerWeights = std::array<N, 4>;

// By hand, so that sums have one order whatever N is, and values are the same with derivatives and without.
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class N>
Vector<N> quotient(const Vector<N>& a, const N& b) {
  return {a[0] / b, a[1] / b, a[2] / b};
}
template <class N>
N norm(const Vector<N>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// q - eta; numbers that carry derivatives get those by eta.
template <class N, Scalar R>
Vector<N> from_point(const Vec3<R>& q, const Vec3<R>& eta) {
  Vector<N> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = N(R(q[i] - eta[i]));
    if constexpr (!std::same_as<N, R>) x[i].gradient[i] = R(-1);
  }
  return x;
}

/// Weights where the formula is 0/0: limits that are known, derivatives that are not.
template <class N>
CornerWeights<N> without_derivatives(const std::array<scalar_of<N>, 4>& w) {
  if constexpr (std::same_as<N, scalar_of<N>>) return w;
  else
    return {N::without_derivatives(w[0]), N::without_derivatives(w[1]), N::without_derivatives(w[2]),
            N::without_derivatives(w[3])};
}

/// tan of half the angles from each unit direction to the next, counted about `axis`, summed over the two at each:
/// Floater's mean value weights of the centre among points in these directions, times their distances.
template <class N>
CornerWeights<N> half_tangents(const std::array<Vector<N>, 4>& directions, const Vector<N>& axis) {
  using std::isfinite;
  using R = scalar_of<N>;
  const N one(R(1));
  CornerWeights<N> tangent, sum;
  for (int i = 0; i < 4; ++i) {
    const Vector<N>&a = directions[i], &b = directions[(i + 1) % 4];
    const N sine = dot(axis, cross(a, b)), cosine = dot(a, b);
    tangent[i] = value_of(cosine) >= 0 ? sine / (one + cosine) : (one - cosine) / sine;
    // Two opposite points have no centre between them, so only these two corners get weights.
    if (!isfinite(value_of(tangent[i]))) {
      std::array<R, 4> between{R(0), R(0), R(0), R(0)};
      between[i] = between[(i + 1) % 4] = R(1);
      return without_derivatives<N>(between);
    }
  }
  for (int i = 0; i < 4; ++i) sum[i] = tangent[(i + 3) % 4] + tangent[i];
  return sum;
}

/// angle(a, b)/(2 |a x b|) from s = |a x b|^2 and d = a.b: what an arc's normal a x b is multiplied with in the mean
/// vector.
template <Scalar R>
R arc_factor(const R& s, const R& d) {
  using std::atan2, std::sqrt;
  const R length = sqrt(s);
  return atan2(length, d) / (2 * length);
}

/// With derivatives, by forms that keep their digits for short arcs. Between aligned points it has its limit, which its
/// derivatives need.
template <Scalar R>
SecondOrder<R> arc_factor(const SecondOrder<R>& s, const SecondOrder<R>& d) {
  const R inverse = 1 / d.value, square = s.value + d.value * d.value;
  const R y = s.value * inverse * inverse;
  Partials<R> f;
  f.f = s.value > 0 ? arc_factor(s.value, d.value) : R(inverse / 2);
  // f is atan(sqrt y)/sqrt(y)/(2 d): derivatives by d are rational, those by s are what atan leaves after some terms.
  f.y = -1 / (2 * square);
  f.yy = d.value / (square * square);
  f.xy = 1 / (2 * square * square);
  if (d.value > 0 && y < R(0.25)) {
    const auto k = atan_remainders<2>(y, std::numeric_limits<R>::digits10 + 2);
    const R cube = inverse * inverse * inverse;
    f.x = -k[1] * cube / 2;
    f.xx = k[2] * cube * inverse * inverse;
  } else {
    f.x = (d.value / (2 * square) - f.f) / (2 * s.value);
    f.xx = (-d.value / (2 * square * square) - 3 * f.x) / (2 * s.value);
  }
  return composed(f, s, d);
}

/// The mean vector of a spherical polygon: the integral of x over it, half the sum of its arcs' lengths times their
/// normals ([T18] Eq 13 for quads).
template <class N>
struct PolygonMean {
  using R = scalar_of<N>;
  Vector<N> m{N(R(0)), N(R(0)), N(R(0))};
  R arcs = 0;  ///< half the sum of the arcs' lengths: what |m| would be if nothing cancelled

  explicit PolygonMean(const std::array<Vector<N>, 4>& to_corner) {
    using std::sqrt;
    for (int i = 0; i < 4; ++i) {
      const Vector<N>&a = to_corner[i], &b = to_corner[(i + 1) % 4], n = cross(a, b);
      const N s = dot(n, n), d = dot(a, b);
      // An arc without a plane adds nothing. Next to that case its normal is short, but its derivatives are not.
      if (!(value_of(s) > 0) && (std::same_as<N, R> || !(value_of(d) > 0))) continue;
      const N factor = arc_factor(s, d);
      for (int c = 0; c < 3; ++c) m[c] += factor * n[c];
      arcs += value_of(factor) * sqrt(value_of(s));
    }
  }
};

/// The weights w of a quad's corners with sum w_i (q_i - eta) = m, m its mean vector.
///
/// With axis v = m/|m|, corners in directions u_i at angles theta_i from it and e_i their unit tangents at v, the mean
/// value property sum T_i e_i = 0 is sum T_i/sin(theta_i) u_i = v sum T_i cot(theta_i). All weights are zero where m
/// vanishes up to rounding: this is right in the plane of a planar quad; elsewhere the limit does not exist, and
/// coordinates are unstable around such points.
template <class N>
class SphericalQuad {
 public:
  using R = scalar_of<N>;

  CornerWeights<N> weights{N(R(0)), N(R(0)), N(R(0)), N(R(0))};
  /// How much of the arcs is left in m, in [0, 1]. Weights lose as many digits as it has zeros, first derivatives
  /// twice, second ones three times that.
  R remainder = 0;

  SphericalQuad(const Quad<R>& q, const Vec3<R>& eta) {
    std::array<Vector<N>, 4> to_corner, tangents;
    for (int i = 0; i < 4; ++i) to_corner[i] = from_point<N>(q[i], eta);
    const PolygonMean<N> mean(to_corner);
    const N size = norm(mean.m);
    remainder = value_of(size) / mean.arcs;
    // Four arcs of at most pi that cancel leave only rounding.
    if (!(value_of(size) > 16 * std::numeric_limits<R>::epsilon())) return;
    const Vector<N> v = quotient(mean.m, size);
    CornerWeights<N> sine, distance;
    for (int i = 0; i < 4; ++i) {
      distance[i] = norm(to_corner[i]);
      const Vector<N> u = quotient(to_corner[i], distance[i]), across = cross(v, u);
      sine[i] = norm(across);
      if (!(value_of(sine[i]) > 0)) {
        std::array<R, 4> alone{R(0), R(0), R(0), R(0)};
        alone[i] = value_of(size) / value_of(distance[i]);
        weights = without_derivatives<N>(alone);
        return;
      }
      tangents[i] = quotient(cross(across, v), sine[i]);
    }
    weights = half_tangents(tangents, v);
    N sum(R(0));
    for (int i = 0; i < 4; ++i) {
      sum += weights[i] * dot(to_corner[i], v) / (distance[i] * sine[i]);
      weights[i] /= sine[i] * distance[i];
    }
    for (N& w : weights) w *= size / sum;
  }
};

/// Mean value coordinates within a planar quad (Floater 2003), for a point off its border: the limit of the coordinates
/// there.
template <Scalar R>
std::array<R, 4> planar_coordinates(const Quad<R>& q, const Vec3<R>& eta) {
  std::array<Vector<R>, 4> directions;
  std::array<R, 4> distance;
  for (int i = 0; i < 4; ++i) {
    const Vector<R> x = from_point<R>(q[i], eta);
    distance[i] = norm(x);
    directions[i] = quotient(x, distance[i]);
  }
  const Vector<R> normal = cross(from_point<R>(q[2], q[0]), from_point<R>(q[3], q[1]));
  std::array<R, 4> weights = half_tangents<R>(directions, quotient(normal, norm(normal)));
  R sum = 0;
  for (int i = 0; i < 4; ++i) sum += weights[i] /= distance[i];
  for (R& w : weights) w /= sum;
  return weights;
}

}  // namespace cageproof::adaptive_qmvc
