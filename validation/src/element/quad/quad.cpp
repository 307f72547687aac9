// SPDX-License-Identifier: MIT
// Bilinear quads in space.
#include "../triangle/triangle.h"
#include "patch.h"
#include "regimes.h"

#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace quads {
namespace {

using Vec = Vec3<double>;

Quad<double> quad_of(Corners q) { return {q[0], q[1], q[2], q[3]}; }

template <Scalar R>
struct Surface {
  std::span<const Vec3<R>> q;
  Vec3<R> at(const R& u, const R& v) const {
    return (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * (u * q[2] + (1 - u) * q[3]);
  }
  Vec3<R> along_u(const R& v) const { return (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]); }
  Vec3<R> along_v(const R& u) const { return (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]); }
};

// One step of Gauss and Newton's towards the nearest point of the whole bilinear surface.
template <Scalar R>
void approach(const Surface<R>& surface, const Vec3<R>& point, R& u, R& v) {
  const Vec3<R> a = surface.along_u(v), b = surface.along_v(u), r = point - surface.at(u, v);
  const R aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ar = a.dot(r), br = b.dot(r), whole = aa * bb - ab * ab;
  if (!(whole > 0)) return;
  u += (ar * bb - br * ab) / whole;
  v += (br * aa - ar * ab) / whole;
}

// Parameters of the nearest point of the whole bilinear surface, in doubles.
std::array<double, 2> rough_foot(Corners q, const Vec& point) {
  // The unit is chosen so that no product leaves the exponent range.
  double largest = point.cwiseAbs().maxCoeff();
  for (const Vec& corner : q) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  const double unit = largest > 0 && std::isfinite(largest) ? std::ldexp(1, -std::ilogb(largest)) : 1;
  std::array<Vec, 4> scaled;
  for (int k = 0; k < 4; ++k) scaled[k] = unit * q[k];
  double u = 0.5, v = 0.5;
  for (int step = 0; step < 12; ++step) approach<double>({scaled}, Vec(unit * point), u, v);
  return {u, v};
}

// The same to the digits of R, which each step doubles. It starts at a corner where that is nearer than the rough foot:
// next to a corner that is nearly straight the steps in doubles go astray.
template <Scalar R>
std::array<R, 2> foot_in(CornersIn<R> q, const Vec3<R>& point) {
  std::array<Vec, 4> rounded;
  for (int k = 0; k < 4; ++k) rounded[k] = convert<double>(q[k]);
  const auto [u, v] = rough_foot(rounded, convert<double>(point));
  const Surface<R> surface{q};
  std::array<R, 2> at{R(u), R(v)};
  const auto off = [&](const std::array<R, 2>& start) {
    const Vec3<R> away = point - surface.at(start[0], start[1]);
    return R(away.dot(away));
  };
  R least = off(at);
  for (const auto& [cu, cv] : {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}}) {
    const std::array<R, 2> corner{R(cu), R(cv)};
    if (const R squared = off(corner); squared < least) {
      least = squared;
      at = corner;
    }
  }
  for (int step = 0; step < 5; ++step) approach<R>({q}, point, at[0], at[1]);
  return at;
}

// The implicit equation of the surface would not do: of a quad that rounding twists it is next to the square of the
// plane's.
template <Scalar R>
R height(CornersIn<R> q, const Vec3<R>& point) {
  const Surface<R> surface{q};
  const auto [u, v] = foot_in<R>(q, point);
  const Vec3<R> normal = surface.along_u(v).cross(surface.along_v(u)), off = point - surface.at(u, v);
  return normal.dot(off);
}

Mp200 off_surface(CornersIn<Mp200> q, const Vec3<Mp200>& point) {
  const auto [u, v] = foot_in<Mp200>(q, point);
  const Surface<Mp200> surface{q};
  const Vec3<Mp200> normal = surface.along_u(v).cross(surface.along_v(u)), off = point - surface.at(u, v);
  return normal.dot(off) / Mp200(sqrt(normal.dot(normal)));
}

std::array<Mp100, 4> basis(Corners corners, const Vec& point) {
  std::array<Vec3<Mp100>, 4> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<Mp100>(corners[k]);
  const auto on = on_quad(quad_of(corners), point);
  Mp100 u = on ? on->u : 0.5, v = on ? on->v : 0.5;
  // From a double's digits to a hundred, which each step doubles.
  for (int step = 0; step < 5; ++step) approach<Mp100>({q}, convert<Mp100>(point), u, v);
  return {Mp100((1 - u) * (1 - v)), Mp100(u * (1 - v)), Mp100(u * v), Mp100((1 - u) * v)};
}

Vec3<Mp100> normal(CornersIn<Mp100> q, const std::array<Mp100, 4>& at) {
  const Surface<Mp100> surface{q};
  const Vec3<Mp100> a = surface.along_u(Mp100(at[2] + at[3])), b = surface.along_v(Mp100(at[1] + at[2]));
  return a.cross(b);
}

Mp200 aspect(CornersIn<Mp200> q) {
  Mp200 least = -1;
  for (int k = 0; k < 4; ++k) {
    const Vec3<Mp200> a = q[(k + 1) % 4] - q[k], b = q[(k + 2) % 4] - q[k], n = a.cross(b);
    const Mp200 squared = n.dot(n);
    if (least < 0 || squared < least) least = squared;
  }
  const Mp200 longest = longest_edge<Mp200>(q);
  return Mp200(sqrt(least)) / (longest * longest);
}

Vec at(Corners q, double u, double v) { return Surface<double>{q}.at(u, v); }

Vec foot(Corners q, const Vec& point) {
  const auto [u, v] = rough_foot(q, point);
  return at(q, u, v);
}

Vec across(Corners q, const Vec& edge) { return edge.cross((q[2] - q[0]).cross(q[3] - q[1]).normalized()); }

double distance(Corners q, const Vec& point, double enough) { return distance_to_quad(point, quad_of(q), enough); }

SurfacePoint surface_point(Corners c, double s, double r) {
  const Surface<double> surface{c};
  return {(1 - s) * (1 - r) * c[0] + s * (1 - r) * c[1] + s * r * c[2] + (1 - s) * r * c[3],
          surface.along_u(r).cross(surface.along_v(s)).normalized()};
}

}  // namespace
}  // namespace quads

const ElementSampling& quad_sampling() {
  using namespace quads;
  static const ElementSampling sampling{
      .kind = ElementKind::Quad,
      .regimes = quads::regimes(),
      .cyclic = true,
      .border_edges = 4,
      .exact = {.height = height<Mp100>, .off_surface = off_surface, .basis = basis, .normal = normal},
      .search = {.valid = [](Corners q) { return !invalid_because(quad_of(q)); },
                 .aspect = aspect,
                 .at = at,
                 .foot = foot,
                 .across = across},
      .locator = {.distance = distance, .surface_point = surface_point},
      // Twisted, and cut by the slice from side to side.
      .field = {.corners = {{{0, 0, 0}, {1, 0, 0}, {0.9, 0.4, -0.8}, {0.1, -0.1, -0.8}}},
                .origin = {-0.6, -0.8, -0.271},
                .extent = {2.2, 1.6}}};
  return sampling;
}

}  // namespace cageproof::validation
