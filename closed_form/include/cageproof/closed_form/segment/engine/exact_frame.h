// SPDX-License-Identifier: MIT
// The frame from exact differences of the coordinates.
#pragma once

#include "cageproof/closed_form/arithmetic/tracked.h"
#include "cageproof/closed_form/arithmetic/wide.h"
#include "cageproof/closed_form/segment/engine/frame.h"
#include "cageproof/core/exact_geometry.h"
#include "cageproof/core/orientation.h"

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

template <Scalar R>
R plane_length(const R& x, const R& y) {
  using std::sqrt;
  if constexpr (is_multiprecision<R>) return sqrt(x * x + y * y);
  else return std::hypot(x, y);
}

/// v 2^exponent, exact except where it underflows.
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
  using std::abs, std::log, std::max;
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
  for (int i = 0; i < 2; ++i) log_r[i] = log(r[i]);
  if constexpr (std::same_as<R, double>)
    if (!at_end && near_exponent - exponent < -1000)
      log_r[near_end] = log(near_mantissa) + (near_exponent - exponent) * std::numbers::ln2;
  set_angle_and_ratio();
}

}  // namespace cageproof::closed_form::segment
