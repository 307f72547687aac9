// SPDX-License-Identifier: MIT
// The frame from exact differences of the coordinates: in double, in multiprecision, and with bounds of its rounding.
#pragma once

#include "cageproof/closed_form/arithmetic/tracked.h"
#include "cageproof/closed_form/arithmetic/wide.h"
#include "cageproof/closed_form/triangle/engine/frame.h"
#include "cageproof/core/geometry/exact_geometry.h"

#include <optional>

namespace cageproof::closed_form::triangle {

/// The power of two just above x > 0, infinite where x is not finite; one for multiprecision, whose exponents do not
/// overflow.
template <Scalar R>
R unit_of(const R& x) {
  if constexpr (is_multiprecision<R>) return R(1);
  else return std::isfinite(x) ? std::ldexp(R(1), std::ilogb(x) + 1) : std::numeric_limits<R>::infinity();
}

/// Products of geometry are formed in double-double, good to 2^-104 of their terms. Below this multiple of the terms
/// too few digits are left: heights are then taken from exact_heights, and a point is `extreme` where the normal is so
/// small.
inline constexpr double kDoubtful = 0x1p-46;

/// In double, distances below 2^-kExtreme of the largest are extreme; at that limit, their eighth powers are still
/// normal numbers. So are units beyond 2^+-kExtremeUnit, in which differences of coordinates may overflow; for points
/// on the triangle, units beyond 2^+-(2 kExtreme).
inline constexpr int kExtreme = 120, kExtremeUnit = 900;

/// An exact number in R, rounded once; a tracked number counts that rounding.
template <class R, class W>
R rounded_to(const W& x) {
  if constexpr (Scalar<R>) return static_cast<R>(x);
  else return R::rounded(decltype(R::value)(x), 0);
}

template <class R>
Frame<R>::Frame(const Triangle<R>& t, const Vec3<R>& eta) requires Scalar<R> {
  if constexpr (is_multiprecision<R>)
    *this =
        Frame(ExactTriangle({convert<Mp200>(t[0]), convert<Mp200>(t[1]), convert<Mp200>(t[2])}, convert<Mp200>(eta)));
  else set(t, eta);
}

template <class R>
template <class W>
Frame<R>::Frame(const ExactTriangleIn<W>& x) {
  using std::sqrt;
  const auto number = [](const W& exact) { return rounded_to<R>(exact); };
  const auto vector = [&](const Vec3<W>& v) { return Vec3<R>(number(v[0]), number(v[1]), number(v[2])); };
  const auto length = [](const Vec3<R>& v) { return R(sqrt(R(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]))); };
  const auto over = [](const Vec3<R>& v, const R& by) { return Vec3<R>(v[0] / by, v[1] / by, v[2] / by); };
  for (int i = 0; i < 3; ++i) {
    p[i] = vector(x.p[i]);
    r[i] = length(p[i]);
  }
  find_far_corner();
  const Vec3<R> normal = vector(x.normal);
  area2 = length(normal);
  n = over(normal, area2);
  d = -number(x.volume) / area2;
  for (int i = 0; i < 3; ++i) {
    FrameEdge<R>& e = edges[i];
    const Vec3<R> along = vector(x.e[i]);
    e.length = length(along);
    e.u = over(along, e.length);
    const R scale = e.length * area2;
    e.nu = over(vector(x.outward[i]), scale);
    e.h = number(x.beside[i]) / scale;
    e.s0 = number(x.before[i]) / e.length;
    e.s1 = number(x.after[i]) / e.length;
    e.r0 = r[i];
    e.r1 = r[(i + 1) % 3];
    e.D2 = e.h * e.h + d * d;
  }
}

template <class R>
void Frame<R>::set(const Triangle<R>& t, const Vec3<R>& eta) requires std::same_as<R, double> {
  using std::abs, std::max, std::sqrt;
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) largest = max({largest, abs(t[i][c] - eta[c]), abs(t[(i + 1) % 3][c] - t[i][c])});
  unit = unit_of(largest);
  extreme = !(abs(std::ilogb(unit)) <= kExtremeUnit);
  if (extreme) return;
  const auto see = [this](double x) { extreme = extreme || !(abs(x) >= std::ldexp(1., -kExtreme)); };
  const double scale = 1 / unit;
  std::array<WideVec<DoubleDouble>, 3> wp, we;
  for (int i = 0; i < 3; ++i) {
    // Scaling by a power of two is exact, so it may come before the difference.
    wp[i] = wide_difference<double>(t[i] * scale, eta * scale);
    we[i] = wide_difference<double>(t[(i + 1) % 3] * scale, t[i] * scale);
    p[i] = narrow<double>(wp[i]);
    r[i] = sqrt(p[i].dot(p[i]));
    if (t[i] != eta) see(p[i].cwiseAbs().maxCoeff());
  }
  find_far_corner();
  double terms = 0;  // of the normal's components, before they cancel
  for (int i = 0; i < 3; ++i) terms = max(terms, narrow<double>(we[i]).squaredNorm());
  const WideVec<DoubleDouble> normal = cross(we[0], we[1]);
  const Vec3<double> N = narrow<double>(normal);
  area2 = sqrt(N.dot(N));
  extreme = extreme || !(area2 > kDoubtful * terms);
  n = N / area2;
  std::optional<ExactHeights> exact;
  const auto exactly = [&]() -> const ExactHeights& {
    if (!exact) exact = exact_heights(t, eta, std::ilogb(unit));
    return *exact;
  };
  int nearest = r[0] <= r[1] ? 0 : 1;
  if (r[2] < r[nearest]) nearest = 2;
  double volume = static_cast<double>(dot(normal, wp[nearest]));
  const bool is_doubtful = abs(volume) <= kDoubtful * terms * r[nearest];
  if (is_doubtful) volume = exactly().volume;
  d = -volume / area2;
  if (!is_doubtful || exactly().volume_sign != 0) see(d);
  for (int i = 0; i < 3; ++i) {
    FrameEdge<R>& e = edges[i];
    const int j = (i + 1) % 3;
    const Vec3<double> along = narrow<double>(we[i]);
    e.length = sqrt(along.dot(along));
    see(e.length);
    e.u = along / e.length;
    const WideVec<DoubleDouble> outward = cross(we[i], normal);
    e.nu = narrow<double>(outward) / (e.length * area2);
    const double near_end = r[i] <= r[j] ? r[i] : r[j];
    double beside = static_cast<double>(dot(outward, wp[r[i] <= r[j] ? i : j]));
    if (abs(beside) <= kDoubtful * terms * e.length * near_end) {
      beside = exactly().beside[i];
      if (exactly().beside_sign[i] != 0) see(beside / (e.length * area2));
    }
    e.h = beside / (e.length * area2);
    e.s0 = static_cast<double>(dot(we[i], wp[i])) / e.length;
    e.s1 = static_cast<double>(dot(we[i], wp[j])) / e.length;
    e.r0 = r[i];
    e.r1 = r[j];
    e.D2 = e.h * e.h + d * d;
  }
  // On the triangle limits are computed from results in the caller's unit, which may leave double's range.
  extreme = extreme || (on_triangle() && abs(std::ilogb(unit)) > 2 * kExtreme);
}

template <class R>
Frame<R>::Frame(const Frame<double>& seen, const Triangle<double>& t,
                const Vec3<double>& eta) requires std::same_as<R, Tracked<DoubleDouble>> : unit(seen.unit),
                                                                                           far_corner(seen.far_corner) {
  const auto difference = [scale = 1 / seen.unit](const Vec3<double>& a, const Vec3<double>& b) {
    const WideVec<DoubleDouble> v = wide_difference<double>(a * scale, b * scale);
    return Vec3<R>(R(v[0], 0), R(v[1], 0), R(v[2], 0));
  };
  const auto dot = [](const Vec3<R>& a, const Vec3<R>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const Vec3<R>& a, const Vec3<R>& b) {
    return Vec3<R>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  };
  const auto over = [](const Vec3<R>& a, const R& b) { return Vec3<R>(a[0] / b, a[1] / b, a[2] / b); };
  std::array<Vec3<R>, 3> along;
  for (int i = 0; i < 3; ++i) {
    p[i] = difference(t[i], eta);
    r[i] = sqrt(dot(p[i], p[i]));
    along[i] = difference(t[(i + 1) % 3], t[i]);
  }
  const int nearest = seen.r[0] <= seen.r[1] && seen.r[0] <= seen.r[2] ? 0 : seen.r[1] <= seen.r[2] ? 1 : 2;
  const Vec3<R> normal = cross(along[0], along[1]);
  area2 = sqrt(dot(normal, normal));
  n = over(normal, area2);
  // A height that is exactly zero was found to be so in double.
  if (seen.d != 0) d = -dot(normal, p[nearest]) / area2;
  for (int i = 0; i < 3; ++i) {
    FrameEdge<R>& e = edges[i];
    const int j = (i + 1) % 3;
    e.length = sqrt(dot(along[i], along[i]));
    e.u = over(along[i], e.length);
    e.nu = over(cross(along[i], normal), e.length * area2);
    if (seen.edges[i].h != 0) e.h = dot(e.nu, p[seen.r[i] <= seen.r[j] ? i : j]);
    e.s0 = dot(along[i], p[i]) / e.length;
    e.s1 = dot(along[i], p[j]) / e.length;
    e.r0 = r[i];
    e.r1 = r[j];
    e.D2 = e.h * e.h + d * d;
  }
}

/// Whether the heights have certain signs in double-double, as forms that branch on them need.
inline bool heights_are_certain(const Frame<Tracked<DoubleDouble>>& f) {
  constexpr double kCertain = 0x1p-60;  // a relative error
  const auto certain = [](const Tracked<DoubleDouble>& x) {
    return roundoff_of<DoubleDouble>() * x.error <= kCertain * x.magnitude();
  };
  return certain(f.d) && certain(f.edges[0].h) && certain(f.edges[1].h) && certain(f.edges[2].h);
}

/// A frame's number as a tracked one. A number computed in double has at most eight roundings. A number from a wider
/// type, which knows its error, is rounded once more.
template <class R, class S>
R tracked_from(const S& x) {
  using T = decltype(R::value);
  if constexpr (std::same_as<T, S>) {
    return R(x, 8 * size_of(x));
  } else {
    using Wider = decltype(S::value);
    const T value(x.value);
    return R(value, size_of(value) + static_cast<ErrorOf<T>>(x.error * (roundoff_of<Wider>() / roundoff_of<T>())));
  }
}

template <class R>
template <class S>
Frame<R>::Frame(const Frame<S>& other)
    : area2(tracked_from<R>(other.area2)), unit(tracked_from<R>(other.unit)), far_corner(other.far_corner) {
  const auto vector = [](const Vec3<S>& v) {
    return Vec3<R>(tracked_from<R>(v[0]), tracked_from<R>(v[1]), tracked_from<R>(v[2]));
  };
  n = vector(other.n);
  d = tracked_from<R>(other.d);
  for (int i = 0; i < 3; ++i) {
    const FrameEdge<S>& from = other.edges[i];
    p[i] = vector(other.p[i]);
    r[i] = tracked_from<R>(other.r[i]);
    edges[i] = {vector(from.u),           vector(from.nu),          tracked_from<R>(from.length),
                tracked_from<R>(from.h),  tracked_from<R>(from.s0), tracked_from<R>(from.s1),
                tracked_from<R>(from.r0), tracked_from<R>(from.r1), tracked_from<R>(from.D2)};
  }
}

}  // namespace cageproof::closed_form::triangle
