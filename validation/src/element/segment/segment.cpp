// SPDX-License-Identifier: MIT
// Segments in the plane.
#include "segment.h"

#include "regimes.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {

double distance_to_segment(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b) {
  const Vec3<double> ab = b - a;
  const double length = ab.dot(ab), t = length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0;
  return (p - a - t * ab).norm();
}

namespace segments {
namespace {

using Vec = Vec3<double>;

// At right angles to an edge, on its right, and as long.
template <Scalar R>
Vec3<R> right_of(const Vec3<R>& edge) {
  return {edge[1], R(-edge[0]), R(0)};
}

template <Scalar R>
R height(CornersIn<R> s, const Vec3<R>& point) {
  return right_of<R>(s[1] - s[0]).dot(Vec3<R>(point - s[0]));
}

Mp200 off_surface(CornersIn<Mp200> s, const Vec3<Mp200>& point) {
  const Vec3<Mp200> extent = right_of<Mp200>(s[1] - s[0]);
  return height<Mp200>(s, point) / Mp200(sqrt(extent.dot(extent)));
}

std::array<Mp100, 4> basis(Corners s, const Vec& point) {
  const Vec3<Mp100> from = convert<Mp100>(s[0]), along = convert<Mp100>(s[1]) - from;
  const Mp100 share = along.dot(Vec3<Mp100>(convert<Mp100>(point) - from)) / along.dot(along);
  return {Mp100(1 - share), share, Mp100(0), Mp100(0)};
}

Vec3<Mp100> normal(CornersIn<Mp100> s, const std::array<Mp100, 4>&) { return right_of<Mp100>(s[1] - s[0]); }

Vec at(Corners s, double parameter, double) { return s[0] + parameter * (s[1] - s[0]); }

Vec foot(Corners s, const Vec& point) {
  const Vec along = s[1] - s[0];
  return s[0] + (point - s[0]).dot(along) / along.squaredNorm() * along;
}

double distance(Corners s, const Vec& point, double) { return distance_to_segment(point, s[0], s[1]); }

SurfacePoint surface_point(Corners s, double parameter, double) {
  return {at(s, parameter, 0), right_of<double>(s[1] - s[0]).normalized()};
}

}  // namespace
}  // namespace segments

const ElementSampling& segment_sampling() {
  using namespace segments;
  static const ElementSampling sampling{
      .kind = ElementKind::Segment,
      .regimes = segments::regimes(),
      .cyclic = false,
      .border_edges = 0,
      .exact = {.height = height<Mp100>, .off_surface = off_surface, .basis = basis, .normal = normal},
      .search = {.valid = [](Corners) { return true; },
                 .aspect = [](CornersIn<Mp200>) { return Mp200(1); },
                 .at = at,
                 .foot = foot,
                 .across = [](Corners, const Vec3<double>& edge) { return right_of<double>(edge); }},
      .locator = {.distance = distance, .surface_point = surface_point},
      .field = {.corners = {{{0, 0, 0}, {1, 0, 0}}}, .origin = {-0.6, -0.8, 0}, .extent = {2.2, 1.6}}};
  return sampling;
}

}  // namespace cageproof::validation
