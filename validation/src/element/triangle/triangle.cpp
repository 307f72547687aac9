// SPDX-License-Identifier: MIT
// Triangles in space.
#include "triangle.h"

#include "../segment/segment.h"
#include "regimes.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {

double distance_to_triangle(const Vec3<double>& p, const Triangle<double>& t) {
  const Vec3<double> n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool within = n.squaredNorm() > 0;
  double nearest_edge = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3<double>&a = t[i], &b = t[(i + 1) % 3];
    within = within && (b - a).cross(p - a).dot(n) >= 0;
    nearest_edge = std::min(nearest_edge, distance_to_segment(p, a, b));
  }
  return within ? std::abs((p - t[0]).dot(n)) / n.norm() : nearest_edge;
}

namespace triangles {
namespace {

using Vec = Vec3<double>;

template <Scalar R>
Vec3<R> area(CornersIn<R> t) {
  const Vec3<R> a = t[1] - t[0], b = t[2] - t[0];
  return a.cross(b);
}

template <Scalar R>
R height(CornersIn<R> t, const Vec3<R>& point) {
  return area<R>(t).dot(Vec3<R>(point - t[0]));
}

Mp200 off_surface(CornersIn<Mp200> t, const Vec3<Mp200>& point) {
  const Vec3<Mp200> extent = area<Mp200>(t);
  return height<Mp200>(t, point) / Mp200(sqrt(extent.dot(extent)));
}

std::array<Mp100, 4> basis(Corners corners, const Vec& point) {
  std::array<Vec3<Mp100>, 3> t;
  for (int k = 0; k < 3; ++k) t[k] = convert<Mp100>(corners[k]);
  const Vec3<Mp100> p = convert<Mp100>(point), n = area<Mp100>(t);
  const Mp100 whole = n.dot(n);
  std::array<Mp100, 4> found{};
  for (int k = 0; k < 3; ++k) {
    const Vec3<Mp100> a = t[(k + 1) % 3] - p, b = t[(k + 2) % 3] - p;
    found[k] = a.cross(b).dot(n) / whole;
  }
  return found;
}

Vec3<Mp100> normal(CornersIn<Mp100> t, const std::array<Mp100, 4>&) { return area<Mp100>(t); }

Mp200 aspect(CornersIn<Mp200> t) {
  const Vec3<Mp200> n = area<Mp200>(t);
  const Mp200 longest = longest_edge<Mp200>(t);
  return Mp200(sqrt(n.dot(n))) / (longest * longest);
}

Vec at(Corners t, double s, double r) { return t[0] + s * (t[1] - t[0]) + r * (t[2] - t[0]); }

Vec unit_normal(Corners t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

Vec foot(Corners t, const Vec& point) {
  const Vec n = unit_normal(t);
  return point - (point - t[0]).dot(n) * n;
}

double distance(Corners t, const Vec& point, double) { return distance_to_triangle(point, {t[0], t[1], t[2]}); }

SurfacePoint surface_point(Corners t, double s, double r) {
  if (s + r > 1) {
    s = 1 - s;
    r = 1 - r;
  }
  return {at(t, s, r), unit_normal(t)};
}

}  // namespace
}  // namespace triangles

const ElementSampling& triangle_sampling() {
  using namespace triangles;
  static const ElementSampling sampling{
      .kind = ElementKind::Triangle,
      .regimes = triangles::regimes(),
      .cyclic = true,
      .border_edges = 3,
      .exact = {.height = height<Mp100>, .off_surface = off_surface, .basis = basis, .normal = normal},
      .search = {
          .valid = [](Corners) { return true; },
          .aspect = aspect,
          .at = at,
          .foot = foot,
          .across = [](Corners t, const Vec3<double>& edge) { return Vec3<double>(edge.cross(unit_normal(t))); }},
      .locator = {.distance = distance, .surface_point = surface_point},
      // The slice is at right angles to the triangle and meets face, edge and outside.
      .field = {
          .corners = {{{0, 0, 0}, {1, 0, 0}, {0.3, 0, -0.8}}}, .origin = {-0.6, -0.8, -0.271}, .extent = {2.2, 1.6}}};
  return sampling;
}

}  // namespace cageproof::validation
