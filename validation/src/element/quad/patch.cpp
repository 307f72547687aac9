// SPDX-License-Identifier: MIT
#include "patch.h"

#include "../triangle/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

double size_of(const Quad<double>& q) { return std::max((q[2] - q[0]).norm(), (q[3] - q[1]).norm()); }

double nearest(const Vec& point, const Quad<double>& q, double resolution, double enough) {
  // Two triangles miss the bilinear quad by v (1 - u) |q0 - q1 + q2 - q3| with v <= u, or the mirror image: at most a
  // quarter.
  const double between =
      std::min(distance_to_triangle(point, {q[0], q[1], q[2]}), distance_to_triangle(point, {q[0], q[2], q[3]}));
  const double sagitta = (q[0] - q[1] + q[2] - q[3]).norm() / 4, least = std::max(0.0, between - sagitta);
  if (least >= enough || 2 * sagitta <= 1e-3 * between || sagitta <= resolution) return least;
  const Vec south = (q[0] + q[1]) / 2, east = (q[1] + q[2]) / 2, north = (q[2] + q[3]) / 2, west = (q[3] + q[0]) / 2;
  const Vec middle = (south + north) / 2;
  for (const Quad<double>& part : {Quad<double>{q[0], south, middle, west},
                                   {south, q[1], east, middle},
                                   {middle, east, q[2], north},
                                   {west, middle, north, q[3]}})
    enough = std::min(enough, nearest(point, part, resolution, enough));
  return enough;
}

}  // namespace

double distance_to_quad(const Vec& point, const Quad<double>& q, double enough) {
  return nearest(point, q, 1e-15 * size_of(q), enough);
}

int crossings_of_quad(const Vec& origin, const Vec& direction, const Quad<double>& q) {
  // The line u = constant runs from p + u dp along w + u dw; it meets the ray's line where det(p + u dp, w + u dw,
  // direction) = 0.
  const Vec p = q[0] - origin, dp = q[1] - q[0], w = q[3] - q[0], dw = q[2] - q[1] - w;
  const Vec by_w = w.cross(direction), by_dw = dw.cross(direction);
  const double a = dp.dot(by_dw), b = p.dot(by_dw) + dp.dot(by_w), c = p.dot(by_w);
  const double discriminant = b * b - 4 * a * c, scale = b * b + 4 * std::abs(a * c);
  constexpr double margin = 1e-9;
  const auto near_unit = [](double x, double slack) { return x > -slack && x < 1 + slack; };
  if (std::abs(discriminant) <= 1e-9 * scale) {
    // Two crossings in one place, or none: only elsewhere along the quad is that an answer.
    const double u = -b / (2 * a);
    return std::isfinite(u) && !near_unit(u, 0.01) ? 0 : scale == 0 && c != 0 ? 0 : -1;
  }
  if (discriminant < 0) return 0;
  const double far = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  int crossings = 0;
  for (const double u : {far / a, c / far}) {
    if (!std::isfinite(u) || !near_unit(u, margin)) continue;
    const Vec from = p + u * dp, along = w + u * dw, across = along.cross(direction);
    const double v = -from.cross(direction).dot(across) / across.squaredNorm();
    if (!std::isfinite(v)) return -1;
    if (!near_unit(v, margin) || (from + v * along).dot(direction) <= 0) continue;
    if (!near_unit(u, -margin) || !near_unit(v, -margin)) return -1;
    ++crossings;
  }
  return crossings;
}

}  // namespace cageproof::validation
