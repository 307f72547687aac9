// SPDX-License-Identifier: MIT
#include "bilinear_surface.h"

#include <algorithm>
#include <limits>

namespace cageproof::validation {

Vec3<double> bilinear_point(const Quad<double>& quad, double u, double v) {
  return (1 - u) * (1 - v) * quad[0] + u * (1 - v) * quad[1] + u * v * quad[2] + (1 - u) * v * quad[3];
}

MeshField bilinear_surface(const Quad<double>& quad, int steps) {
  MeshField found;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i)
      found.vertices.push_back(bilinear_point(quad, static_cast<double>(i) / steps, static_cast<double>(j) / steps));
  for (int j = 0; j < steps; ++j)
    for (int i = 0; i < steps; ++i) {
      const int first = j * (steps + 1) + i;
      found.faces.push_back({first, first + 1, first + steps + 2, first + steps + 1});
    }
  return found;
}

LeastConvex least_convex_projection(const Quad<double>& quad) {
  LeastConvex found{.corner = 0, .sine = std::numeric_limits<double>::infinity(), .projection = quad};
  for (int c = 0; c < 4; ++c) {
    const Vec3<double> along = (quad[(c + 1) % 4] - quad[c]).normalized();
    const Vec3<double> normal = along.cross(quad[(c + 3) % 4] - quad[c]).normalized();
    const Vec3<double> across = normal.cross(along);
    Quad<double> projection;
    for (int k = 0; k < 4; ++k) {
      const Vec3<double> from = quad[k] - quad[c];
      projection[k] = Vec3<double>(along.dot(from), across.dot(from), 0);
    }
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k) {
      const Vec3<double> before = projection[k] - projection[(k + 3) % 4],
                         after = projection[(k + 1) % 4] - projection[k];
      least = std::min(least, before.cross(after)[2] / (before.norm() * after.norm()));
    }
    if (least < found.sine) found = {c, least, projection};
  }
  return found;
}

}  // namespace cageproof::validation
