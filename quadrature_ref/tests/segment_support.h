// SPDX-License-Identifier: MIT
// Samples of segments of the plane in every regime, and the single layer's truth from its antiderivative.
#pragma once

#include "support.h"

namespace cageproof::quadrature_ref {

struct SegmentSample {
  std::string regime;
  Segment<double> corners;
  Vec3<double> point;
};

template <Scalar R>
Segment<R> corners_in(const SegmentSample& s) {
  return {convert<R>(s.corners[0]), convert<R>(s.corners[1])};
}

template <Scalar R>
Result<R> evaluate(const std::string& formula, const std::string& evaluation, const SegmentSample& s, int order) {
  const Segment<R> corners = corners_in<R>(s);
  Result<R> result;
  evaluation_named(formula, evaluation)(Query<R>{corners, convert<R>(s.point), order}, result);
  return result;
}

/// segment.single_layer and its derivatives. With a_k the ends' arc lengths from the foot of the perpendicular and h =
/// x.n,
///   int log r ds = [s log sqrt(s^2 + h^2) - s + h atan(s/h)],
/// whose derivatives along the segment and across it are differences of logarithms, of angles and of rational
/// functions. 200 digits pay for what cancels. h = 0 counts as the limit from inside, where h > 0.
inline Result<Mp200> single_layer_truth(const SegmentSample& sample) {
  using R = Mp200;
  const Segment<R> v = corners_in<R>(sample);
  const Vec3<R> p = convert<R>(sample.point), edge = v[1] - v[0], x0 = v[0] - p, x1 = v[1] - p;
  const R length = sqrt(R(edge[0] * edge[0] + edge[1] * edge[1]));
  const R ux = edge[0] / length, uy = edge[1] / length;
  const R a0 = x0[0] * ux + x0[1] * uy, a1 = x1[0] * ux + x1[1] * uy, h = (x0[0] * edge[1] - x0[1] * edge[0]) / length;
  const R r0 = a0 * a0 + h * h, r1 = a1 * a1 + h * h;
  const auto angle = [&](const R& a) {
    if (h == 0) return a == 0 ? R(0) : R(copysign(R(pi<R>() / 2), a));
    return R(atan(a / h));
  };
  const auto antiderivative = [&](const R& a, const R& square) {
    return R((square == 0 ? R(0) : R(a * log(square) / 2)) - a + h * angle(a));
  };
  const R factor = 1 / (2 * pi<R>());
  Result<R> truth;
  truth.reset(1, 2, 2);
  truth.value[0] = -factor * (antiderivative(a1, r1) - antiderivative(a0, r0));
  // Along u and along n = (u_y, -u_x).
  const R along = factor * (log(r1) - log(r0)) / 2, across = factor * (angle(a1) - angle(a0));
  truth.gradient = {along * ux + across * uy, along * uy - across * ux};
  const R uu = -factor * (a1 / r1 - a0 / r0), un = -factor * h * (1 / r1 - 1 / r0);
  const R xx = uu * (ux * ux - uy * uy) + 2 * un * ux * uy, xy = 2 * uu * ux * uy + un * (uy * uy - ux * ux);
  truth.hessian = {xx, xy, xy, -xx};
  return truth;
}

/// Beside the segment, next to an end, beside the line beyond an end, on it, and far away; scaled, moved and turned.
inline std::vector<SegmentSample> segment_samples() {
  std::vector<SegmentSample> all;
  const auto add = [&](const std::string& regime, const Segment<double>& s, double x, double y) {
    all.push_back({regime, s, {x, y, 0}});
  };
  const auto at = [](double x, double y) { return Vec3<double>(x, y, 0); };
  const Segment<double> flat{at(-1, 0), at(2, 0)}, turned{at(0, 0), at(.75, -1.5)};
  for (const double h : {1., 1e-3, 1e-9, 1e-16, 1e-40, 1e-100}) {
    add("beside", flat, .5, -h);
    add("beside", flat, -.25, h);
    add("end", turned, .6 * h, .8 * h);
    add("end", turned, -.6 * h, -.1 * h);
    add("line", flat, 3.5, h);
    add("line-end", flat, 2 + h, 0);
    add("line-end", turned, -h / 2, h);
  }
  for (const double r : {10., 1e4, 1e8}) {
    add("far", turned, .6 * r, -.8 * r);
    add("far", flat, r, 0);
  }
  add("line", flat, 3, 0);
  for (const double unit : {1e100, 1e-100, 1e8}) {
    add("scaled", {at(.1 * unit, .2 * unit), at(.9 * unit, -.3 * unit)}, .4 * unit, .1 * unit);
    add("moved", {at(unit + .5, unit), at(unit - .25, unit + 1)}, unit, unit);
  }
  // At distance one of a short segment the logarithm is close to zero.
  add("unit-distance", {at(.6, .8), at(.6 + 0x1p-30, .8 + 0x1p-31)}, 0, 0);
  add("unit-distance", {at(.6, .8), at(.6 + 0x1p-50, .8)}, 0, 0);
  // Where rounding put the point on an end there are no derivatives.
  std::erase_if(all, [](const SegmentSample& s) {
    return s.corners[0] == s.corners[1] || s.point == s.corners[0] || s.point == s.corners[1];
  });
  return all;
}

}  // namespace cageproof::quadrature_ref
