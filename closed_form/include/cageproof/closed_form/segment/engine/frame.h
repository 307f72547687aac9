// SPDX-License-Identifier: MIT
// A segment seen from a point: the distances, directions and the angle that every closed form in the plane is built
// from.
#pragma once

#include "cageproof/closed_form/arithmetic/wide.h"
#include "cageproof/closed_form/segment/engine/scalar.h"
#include "cageproof/core/exact_geometry.h"
#include "cageproof/core/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::closed_form::segment {

/// x 2^exponent. In multiprecision, whose exponents do not overflow, frames have the exponent zero.
template <Scalar R>
R shifted(const R& x, int exponent) {
  if constexpr (is_multiprecision<R>) return x;
  else if constexpr (is_tracked<R>) return {std::ldexp(x.value, exponent), std::ldexp(x.error, exponent)};
  else return std::ldexp(x, exponent);
}

/// A number of the plane, re along the segment and im along its outward normal.
template <class R>
struct Complex {
  R re, im;
  friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator*(const R& a, const Complex& b) { return {a * b.re, a * b.im}; }
};

/// Geometry in units of 2^exponent, just above the largest difference of coordinates, so that no power of a length
/// overflows.
///
/// z_i = s_i - i h is end i as the point sees it, along the segment and its normal; closed forms are real and imaginary
/// parts of log(z_1/z_0) = log_ratio + i angle and of powers of the z_i. What depends on a distance that is far below
/// the unit (the nearer end's) has a scale of its own. On the segment (h = 0) every quantity is the limit from inside,
/// where h -> 0 from below; at an end that limit is taken along the normal.
template <Scalar R>
struct Frame {
  Eigen::Matrix<R, 2, 1> u;  ///< unit direction from end 0 to end 1
  Eigen::Matrix<R, 2, 1> n;  ///< outward unit normal, to the right of u
  std::array<int, 2> way;    ///< the signs of u, exactly: what is infinite along the segment is so where u underflows
  R length;
  R h;                 ///< signed distance of the point from the line, positive outside
  std::array<R, 2> s;  ///< arc length of the ends from the nearest point of the line, s[1] - s[0] = length
  R sum;               ///< s[0] + s[1], which is small over the segment's middle: r[1]^2 - r[0]^2 = length sum
  std::array<R, 2> r;  ///< distances of the ends
  R log_ratio;         ///< log(r[1]/r[0]); infinite at an end
  R angle;             ///< under which the segment is seen, with the sign of h: in [-pi, pi]
  std::array<R, 2> log_r;
  int exponent;

  int near_end;     ///< the nearer of the ends
  bool at_end;      ///< the point is that end
  Complex<R> near;  ///< z of the nearer end over its modulus
  R near_mantissa;  ///< that modulus is near_mantissa 2^near_exponent in the caller's units
  int near_exponent;

  Frame(const Segment<R>& segment, const Vec3<R>& eta);
  /// The same with bounds of what was rounded. \pre no number has underflown
  explicit Frame(const Frame<double>& plain) requires is_tracked<R>;

  const R& far_s() const { return s[1 - near_end]; }
  const R& far_r() const { return r[1 - near_end]; }
  /// Whether the point is more than the segment's length away from it.
  bool is_far() const { return r[near_end] > length; }
  /// Whether both ends are about as far, so that differences of what depends on their distances cancel.
  bool are_alike() const {
    const R square = length * sum;
    return 2 * (square < 0 ? R(-square) : square) < r[near_end] * r[near_end];
  }
  /// Whether closed forms that cancel far away hand over to Gauss points: from is_far() on, in multiprecision from a
  /// million lengths on, where they have lost no more than a fraction of their digits.
  bool is_for_sums() const {
    if constexpr (is_multiprecision<R>) return r[near_end] > 1e6 * length;
    else return is_far();
  }
  /// 1/z_i, in units of the frame. \pre not at that end
  Complex<R> scaled_inverse(int i) const {
    if (i != near_end) return {s[i] / r[i] / r[i], h / r[i] / r[i]};
    const int up = exponent - near_exponent;
    return {shifted<R>(near.re / near_mantissa, up), shifted<R>(-near.im / near_mantissa, up)};
  }
  /// 1/z_i, in the caller's units. \pre not at that end
  Complex<R> inverse(int i) const {
    const Complex<R> scaled = scaled_inverse(i);
    return {shifted<R>(scaled.re, -exponent), shifted<R>(scaled.im, -exponent)};
  }
};

template <class W>
WideVec<W> plane_sum(const WideVec<W>& a, const WideVec<W>& b) {
  return {{a[0] + b[0], a[1] + b[1], W{}}};
}
template <class W>
W plane_cross(const WideVec<W>& a, const WideVec<W>& b) {
  return a[0] * b[1] - a[1] * b[0];
}
template <class W>
W plane_dot(const WideVec<W>& a, const WideVec<W>& b) {
  return a[0] * b[0] + a[1] * b[1];
}

template <Scalar R>
R plane_length(const R& x, const R& y) {
  using std::sqrt;
  if constexpr (is_multiprecision<R>) return sqrt(x * x + y * y);
  else return std::hypot(x, y);
}

/// v 2^exponent, exactly but for underflow.
template <Scalar R>
WideVec<Wide<R>> shifted(WideVec<Wide<R>> v, int exponent) {
  if constexpr (std::same_as<R, double>)
    for (DoubleDouble& c : v.c) c = {std::ldexp(c.high, exponent), std::ldexp(c.low, exponent)};
  return v;
}

/// e x p over their lengths, e the segment and p its end `end` seen from the point, from exact differences.
template <Scalar R>
R exact_sine(const ExactSegment& x, int end) {
  const auto square = [](const std::array<Mp200, 2>& v) { return Mp200(v[0] * v[0] + v[1] * v[1]); };
  return static_cast<R>(Mp200(x.cross / sqrt(square(x.e) * square(x.p[end]))));
}

template <Scalar R>
ExactSegment exactly(const Segment<R>& segment, const Vec3<R>& eta) {
  return {{convert<Mp200>(segment[0]), convert<Mp200>(segment[1])}, convert<Mp200>(eta)};
}

/// Cross products are formed in double-double, good to 2^-104 of their terms; below this multiple of the terms they are
/// taken from exact differences.
inline constexpr double kDoubtful = 0x1p-46;

template <Scalar R>
Frame<R>::Frame(const Segment<R>& segment, const Vec3<R>& eta) : exponent(0), near_exponent(0) {
  static_assert(!std::same_as<R, float>, "float is computed in double");
  using std::abs, std::atan2, std::log, std::log1p, std::max;
  // Differences of the largest numbers overflow, so these are taken a sixteenth as large.
  Segment<R> corner = segment;
  Vec3<R> point = eta;  // NOLINT(performance-unnecessary-copy-initialization): double's is changed
  int shrunk = 0;
  if constexpr (std::same_as<R, double>) {
    const double largest =
        max({segment[0].cwiseAbs().maxCoeff(), segment[1].cwiseAbs().maxCoeff(), eta.cwiseAbs().maxCoeff()});
    if (largest > 0x1p1000) {
      shrunk = 4;
      for (Vec3<R>& v : corner) v *= 0x1p-4;
      point *= 0x1p-4;
    }
  }
  const std::array<WideVec<Wide<R>>, 2> exact{wide_difference<R>(corner[0], point),
                                              wide_difference<R>(corner[1], point)};
  const WideVec<Wide<R>> along = wide_difference<R>(corner[1], corner[0]);
  const auto largest_of = [](const WideVec<Wide<R>>& v) {
    return R(max(R(abs(static_cast<R>(v[0]))), R(abs(static_cast<R>(v[1])))));
  };
  const auto exponent_of = [](const R& x) {
    if constexpr (is_multiprecision<R>) return 0;
    else return x == 0 ? 0 : std::ilogb(x) + 1;
  };
  const int scale = exponent_of(max({largest_of(exact[0]), largest_of(exact[1]), largest_of(along)}));
  exponent = scale + shrunk;

  const WideVec<Wide<R>> e = shifted<R>(along, -scale);
  length = plane_length<R>(static_cast<R>(e[0]), static_cast<R>(e[1]));
  u = {static_cast<R>(e[0]) / length, static_cast<R>(e[1]) / length};
  n = {u[1], -u[0]};
  for (int i = 0; i < 2; ++i) way[i] = (segment[0][i] < segment[1][i]) - (segment[1][i] < segment[0][i]);
  for (int i = 0; i < 2; ++i) {
    const WideVec<Wide<R>> p = shifted<R>(exact[i], -scale);
    r[i] = plane_length<R>(static_cast<R>(p[0]), static_cast<R>(p[1]));
    s[i] = static_cast<R>(plane_dot(e, p)) / length;
  }
  sum = static_cast<R>(plane_dot(e, shifted<R>(plane_sum(exact[0], exact[1]), -scale))) / length;
  near_end = r[0] <= r[1] ? 0 : 1;
  at_end = eta[0] == segment[near_end][0] && eta[1] == segment[near_end][1];

  // The nearer end in a scale of its own, which keeps its direction where the distance itself has few bits left.
  const int near_scale = exponent_of(largest_of(exact[near_end]));
  near_exponent = near_scale + shrunk;
  const WideVec<Wide<R>> p = shifted<R>(exact[near_end], -near_scale);
  near_mantissa = plane_length<R>(static_cast<R>(p[0]), static_cast<R>(p[1]));
  R sine = static_cast<R>(plane_cross(e, p)) / (length * near_mantissa);
  R cosine = static_cast<R>(plane_dot(e, p)) / (length * near_mantissa);
  if constexpr (std::same_as<R, double>) {
    const int side = side_of_line(segment, eta);
    if (side != 0 && abs(sine) <= kDoubtful) sine = exact_sine<double>(exactly<double>(segment, eta), near_end);
    sine = side > 0 ? abs(sine) : -abs(sine);  // on the line: minus zero
    if (side == 0) sine = -0.0;
  } else {
    const ExactSegment x = exactly<R>(segment, eta);
    s = {static_cast<R>(x.before) / length, static_cast<R>(x.after) / length};
    sum = static_cast<R>(x.middle) / length;
    sine = exact_sine<R>(x, near_end);
    cosine = s[near_end] / near_mantissa;
    if (sine == 0) sine = -R(0);
  }
  if (at_end) {
    sine = -1;
    cosine = 0;
  }
  near = {cosine, -sine};
  h = at_end ? -R(0) : R(sine * r[near_end]);
  const R from_inside = at_end ? R(0) : R(h * sine);
  angle = atan2(R(length * sine), R(from_inside + far_s() * cosine));

  for (int i = 0; i < 2; ++i) log_r[i] = log(r[i]);
  if constexpr (std::same_as<R, double>)
    if (!at_end && near_exponent - exponent < -1000)
      log_r[near_end] = log(near_mantissa) + (near_exponent - exponent) * std::numbers::ln2;
  if (is_far() || are_alike()) {
    const R sign(near_end == 0 ? 1 : -1), q = r[near_end];
    log_ratio = sign * log1p(R(sign * length * sum / (q * q))) / 2;
  } else {
    log_ratio = log_r[1] - log_r[0];
  }
}

}  // namespace cageproof::closed_form::segment
