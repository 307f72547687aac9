// SPDX-License-Identifier: MIT
// Posed cages that are inside out.
#pragma once

#include "cageproof/core/cage_elements.h"

#include <string>
#include <vector>

namespace cageproof::deformation {

/// Warns of a posed cage whose volume, or area, is negative.
template <Scalar R>
void warn_of_orientation(const CageElements& elements, const std::vector<Vec3<R>>& vertices,
                         std::vector<std::string>& warnings) {
  R volume = 0;
  const Vec3<R> about = vertices[0];
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    const Vec3<R> u = vertices[corners[0]] - about, v = vertices[corners[1]] - about;
    volume +=
        corners.size() == 2 ? R(u[0] * v[1] - u[1] * v[0]) : R(u.dot(v.cross(Vec3<R>(vertices[corners[2]] - about))));
  }
  if (volume < 0)
    warnings.emplace_back("the posed cage is inside out: its normals point inward, and mirror images are not kept");
}

}  // namespace cageproof::deformation
