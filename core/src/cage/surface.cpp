// SPDX-License-Identifier: MIT
#include "surface.h"

#include <cmath>

namespace cageproof {

int Surface::add_square(double half, double z, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
    vertices.emplace_back(c * x - s * y, s * x + c * y, z);
  return count() - 4;
}

Surface box_corners() {
  Surface s;
  for (int i = 0; i < 8; ++i) s.vertices.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
  return s;
}

Surface cube() {
  Surface s = box_corners();
  for (const auto& f : kBoxFaces) s.add(f[0], f[1], f[2], f[3]);
  return s;
}

Surface icosahedron() {
  constexpr double kPi = std::numbers::pi;
  Surface s;
  const double z = 1 / std::sqrt(5.0);
  s.vertices.emplace_back(0, 0, 1);
  for (int ring = 0; ring < 2; ++ring)
    for (int k = 0; k < 5; ++k) {
      const double angle = (2 * k + ring) * kPi / 5;
      s.vertices.emplace_back(2 * z * std::cos(angle), 2 * z * std::sin(angle), ring == 0 ? z : -z);
    }
  s.vertices.emplace_back(0, 0, -1);
  for (int k = 0; k < 5; ++k) {
    const int upper = 1 + k, upper_next = 1 + (k + 1) % 5, lower = 6 + k, lower_next = 6 + (k + 1) % 5;
    s.add(0, upper, upper_next);
    s.add(upper, lower, upper_next);
    s.add(upper_next, lower, lower_next);
    s.add(11, lower_next, lower);
  }
  return s;
}

Surface open_box(double wall) {
  Surface s;
  const int outer_floor = s.add_square(1, -0.5), outer_rim = s.add_square(1, 0.5);
  const int inner_rim = s.add_square(1 - wall, 0.5), inner_floor = s.add_square(1 - wall, -0.5 + wall);
  s.add(outer_floor, outer_floor + 3, outer_floor + 2, outer_floor + 1);
  s.join(outer_floor, outer_rim, 4);
  s.join(outer_rim, inner_rim, 4);
  s.join(inner_rim, inner_floor, 4);
  s.add(inner_floor, inner_floor + 1, inner_floor + 2, inner_floor + 3);
  return s;
}

}  // namespace cageproof
