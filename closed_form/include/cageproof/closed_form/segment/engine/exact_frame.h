// SPDX-License-Identifier: MIT
// The frame from exact differences of the coordinates.
#pragma once

#include "cageproof/closed_form/arithmetic/tracked.h"
#include "cageproof/closed_form/arithmetic/wide.h"
#include "cageproof/closed_form/segment/engine/frame.h"
#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/geometry/orientation.h"

#include <algorithm>
#include <numbers>

namespace cageproof::closed_form::segment {

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

/// v 2^exponent, exact except where it underflows.
inline WideVec<DoubleDouble> shifted(WideVec<DoubleDouble> v, int exponent) {
  for (DoubleDouble& c : v.c) c = {std::ldexp(c.high, exponent), std::ldexp(c.low, exponent)};
  return v;
}

template <cageproof::Scalar R>
ExactSegment exactly(const Segment<R>& segment, const Vec3<R>& eta) {
  return {{convert<Mp200>(segment[0]), convert<Mp200>(segment[1])}, convert<Mp200>(eta)};
}

/// e x p over their lengths, e the segment and p its end `end` seen from the point, from exact differences.
inline double exact_sine(const ExactSegment& x, int end) {
  const auto square = [](const std::array<Mp200, 2>& v) { return Mp200(v[0] * v[0] + v[1] * v[1]); };
  return static_cast<double>(Mp200(x.cross / sqrt(square(x.e) * square(x.p[end]))));
}

/// Cross products are formed in double-double, good to 2^-104 of their terms. Those below this multiple of the terms
/// are computed exactly.
inline constexpr double kDoubtful = 0x1p-46;

/// An exact number in R, rounded once; a tracked number counts that rounding.
template <Scalar R, class W>
R rounded_to(const W& x) {
  if constexpr (is_tracked<R>) return R::rounded(decltype(R::value)(x), 0);
  else return static_cast<R>(x);
}

template <Scalar R>
template <class W>
Frame<R>::Frame(const ExactSegmentIn<W>& x) : exponent(0), near_exponent(0) {
  using std::log, std::sqrt;
  const auto number = [](const W& exact) { return rounded_to<R>(exact); };
  const auto size_of_pair = [](const R& a, const R& b) { return R(sqrt(R(a * a + b * b))); };
  const std::array<R, 2> e{number(x.e[0]), number(x.e[1])};
  length = size_of_pair(e[0], e[1]);
  u = {e[0] / length, e[1] / length};
  n = {u[1], -u[0]};
  for (int i = 0; i < 2; ++i) {
    way[i] = (x.e[i] > 0) - (x.e[i] < 0);
    r[i] = size_of_pair(number(x.p[i][0]), number(x.p[i][1]));
  }
  s = {number(x.before) / length, number(x.after) / length};
  sum = number(x.middle) / length;
  near_end = r[0] <= r[1] ? 0 : 1;
  at_end = x.p[near_end][0] == 0 && x.p[near_end][1] == 0;
  near_mantissa = r[near_end];
  R sine = at_end ? R(-1) : x.cross == 0 ? R(-R(0)) : R(number(x.cross) / (length * near_mantissa));
  near = {at_end ? R(0) : R(s[near_end] / near_mantissa), -sine};
  h = at_end ? R(-R(0)) : R(sine * near_mantissa);
  for (int i = 0; i < 2; ++i)
    log_r[i] = at_end && i == near_end ? R(-std::numeric_limits<R>::infinity()) : R(log(r[i]));
  set_angle_and_ratio();
}

template <Scalar R>
Frame<R>::Frame(const Segment<R>& segment, const Vec3<R>& eta) {
  static_assert(!std::same_as<R, float>, "float is computed in double");
  if constexpr (is_multiprecision<R>) *this = Frame(exactly<R>(segment, eta));
  else set(segment, eta);
}

template <Scalar R>
void Frame<R>::set(const Segment<R>& given, const Vec3<R>& eta) requires std::same_as<R, double> {
  using std::abs, std::max;
  // Differences of the largest numbers overflow, so these are taken a sixteenth as large.
  Segment<double> corner = given;
  Vec3<double> point = eta;
  int shrunk = 0;
  const double largest =
      max({given[0].cwiseAbs().maxCoeff(), given[1].cwiseAbs().maxCoeff(), eta.cwiseAbs().maxCoeff()});
  if (largest > 0x1p1000) {
    shrunk = 4;
    for (Vec3<double>& v : corner) v *= 0x1p-4;
    point *= 0x1p-4;
  }
  using Wide = WideVec<DoubleDouble>;
  const std::array<Wide, 2> exact{wide_difference<double>(corner[0], point), wide_difference<double>(corner[1], point)};
  const Wide along = wide_difference<double>(corner[1], corner[0]);
  const auto largest_of = [](const Wide& v) {
    return max(abs(static_cast<double>(v[0])), abs(static_cast<double>(v[1])));
  };
  const auto length_of = [](const Wide& v) { return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1])); };
  const auto exponent_of = [](double x) { return x == 0 ? 0 : std::ilogb(x) + 1; };
  const int scale = exponent_of(max({largest_of(exact[0]), largest_of(exact[1]), largest_of(along)}));
  exponent = scale + shrunk;

  const Wide e = segment::shifted(along, -scale);
  length = length_of(e);
  u = {static_cast<double>(e[0]) / length, static_cast<double>(e[1]) / length};
  n = {u[1], -u[0]};
  for (int i = 0; i < 2; ++i) {
    way[i] = (given[0][i] < given[1][i]) - (given[1][i] < given[0][i]);
    const Wide p = segment::shifted(exact[i], -scale);
    r[i] = length_of(p);
    s[i] = static_cast<double>(plane_dot(e, p)) / length;
  }
  sum = static_cast<double>(plane_dot(e, segment::shifted(plane_sum(exact[0], exact[1]), -scale))) / length;
  near_end = r[0] <= r[1] ? 0 : 1;
  at_end = eta[0] == given[near_end][0] && eta[1] == given[near_end][1];

  // The nearer end in a scale of its own, which keeps its direction where the distance itself has few bits left.
  const int near_scale = exponent_of(largest_of(exact[near_end]));
  near_exponent = near_scale + shrunk;
  const Wide p = segment::shifted(exact[near_end], -near_scale);
  near_mantissa = length_of(p);
  double sine = static_cast<double>(plane_cross(e, p)) / (length * near_mantissa);
  double cosine = static_cast<double>(plane_dot(e, p)) / (length * near_mantissa);
  const int side = side_of_line(given, eta);
  if (side != 0 && abs(sine) <= kDoubtful) sine = exact_sine(exactly<double>(given, eta), near_end);
  sine = side > 0 ? abs(sine) : -abs(sine);
  if (side == 0) sine = -0.0;  // on the line
  if (at_end) {
    sine = -1;
    cosine = 0;
  }
  near = {cosine, -sine};
  h = at_end ? -0.0 : sine * r[near_end];
  for (int i = 0; i < 2; ++i) log_r[i] = std::log(r[i]);
  if (!at_end && near_exponent - exponent < -1000)
    log_r[near_end] = std::log(near_mantissa) + (near_exponent - exponent) * std::numbers::ln2;
  set_angle_and_ratio();
}

}  // namespace cageproof::closed_form::segment
