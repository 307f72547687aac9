// SPDX-License-Identifier: MIT
// Posed cages that are inside out.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/numbers/scalar.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cageproof::deformation {

/// The posed cage's volume, or area, up to a positive factor; zero where it is no more than the rounding of vertices
/// and products leaves uncertain.
template <Scalar R>
R signed_extent(const CageElements& elements, std::vector<Vec3<R>> vertices) {
  using std::sqrt;
  const Vec3<R> about = vertices[0];
  R largest = 0;
  for (Vec3<R>& v : vertices) {
    v -= about;
    largest = std::max<R>(largest, v.cwiseAbs().maxCoeff());
  }
  if (!(largest > 0)) return R(0);
  // Numbers of about one, whose products stay in range.
  for (Vec3<R>& v : vertices) v /= largest;
  const auto length = [](const Vec3<R>& v) { return R(sqrt(R(v.dot(v)))); };
  R extent = 0, rounding = 0;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    // Elements by their shorter edges, so that slender ones do not cancel.
    std::size_t first = 0;
    R least = -1;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3<R>& at = vertices[corners[k]];
      const R size = length(vertices[corners[(k + 1) % corners.size()]] - at) *
                     (corners.size() == 2 ? R(1) : length(vertices[corners[(k + 2) % corners.size()]] - at));
      if (least < 0 || size < least) least = size, first = corners.size() == 2 ? 0 : k;
    }
    const Vec3<R>& at = vertices[corners[first]];
    const Vec3<R> u = vertices[corners[(first + 1) % corners.size()]] - at;
    extent += corners.size() == 2 ? R(at[0] * u[1] - at[1] * u[0])
                                  : R(at.dot(u.cross(Vec3<R>(vertices[corners[(first + 2) % corners.size()]] - at))));
    rounding += least;
  }
  rounding *= 64 * unit_roundoff<R>();
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
