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

}  // namespace cageproof::validation
