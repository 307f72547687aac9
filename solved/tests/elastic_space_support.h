// SPDX-License-Identifier: MIT
// Elastic bodies in cages in space, and displacements inside of what their vertices are displaced by.
#pragma once

#include "space_support.h"

namespace cageproof::solved::test {

inline CageCoordinates elastic_at_level(const Cage& cage, int level, double nu) {
  return coordinates(cage, "elastic", {4, 1, nu, static_cast<double>(level)});
}

/// sum E_i u_i, or one of its derivatives: `which` of so many per entry.
inline Vec sum_of(const CageCoordinates& e, const std::vector<double>& entries, const std::function<Vec(const Vec&)>& u,
                  std::size_t width = 1, std::size_t which = 0) {
  Vec sum = Vec::Zero();
  const std::vector<Vec>& vertices = e.elements().vertices();
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Vec here = u(vertices[v]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        sum[static_cast<Eigen::Index>(i)] +=
            entries[(9 * v + 3 * i + j) * width + which] * here[static_cast<Eigen::Index>(j)];
  }
  return sum;
}

inline Vec displaced(const CageCoordinates& e, const std::function<Vec(const Vec&)>& u, const Vec& point) {
  return sum_of(e, values_at(e, point), u);
}

}  // namespace cageproof::solved::test
