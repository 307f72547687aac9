// SPDX-License-Identifier: MIT
// Posed cages that are inside out.
#pragma once

#include "cageproof/core/cage_elements.h"
#include "cageproof/core/scalar.h"

#include <algorithm>
#include <string>
#include <vector>

namespace cageproof::deformation {

/// The posed cage's volume, or area, up to a positive factor; zero where it is no more than rounding.
template <Scalar R>
R signed_extent(const CageElements& elements, std::vector<Vec3<R>> vertices) {
  const Vec3<R> about = vertices[0];
  R largest = 0;
  for (Vec3<R>& v : vertices) {
    v -= about;
    largest = std::max<R>(largest, v.cwiseAbs().maxCoeff());
  }
  if (!(largest > 0)) return R(0);
  // Numbers of at most one, whose products stay in range.
  for (Vec3<R>& v : vertices) v /= largest;
  R extent = 0;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    const Vec3<R>&u = vertices[corners[0]], &v = vertices[corners[1]];
    extent += corners.size() == 2 ? R(u[0] * v[1] - u[1] * v[0]) : R(u.dot(v.cross(vertices[corners[2]])));
  }
  const R rounding = R(64 * static_cast<double>(elements.count())) * unit_roundoff<R>();
  return extent > rounding || extent < -rounding ? extent : R(0);
}

/// Warns of a posed cage whose volume, or area, is negative.
/// \param keeps_mirror_images whether the method does, nonetheless
template <Scalar R>
void warn_of_orientation(const CageElements& elements, const std::vector<Vec3<R>>& vertices,
                         std::vector<std::string>& warnings, bool keeps_mirror_images = false) {
  if (!(signed_extent(elements, vertices) < 0)) return;
  warnings.emplace_back(keeps_mirror_images
                            ? "the posed cage is inside out: its normals point inward"
                            : "the posed cage is inside out: its normals point inward, and mirror images are not kept");
}

}  // namespace cageproof::deformation
