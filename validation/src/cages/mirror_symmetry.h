// SPDX-License-Identifier: MIT
// Cages that are their own mirror images.
#pragma once

#include "cageproof/core/cage/cage_elements.h"

#include <optional>
#include <vector>

namespace cageproof::validation {

/// A plane across one axis (in the plane, a line) through the middle of a cage's box, that its vertices are mirrored
/// at.
struct MirrorSymmetry {
  int axis;
  double middle;            ///< the plane's coordinate
  std::vector<int> vertex;  ///< the mirror image of each

  Vec3<double> operator()(Vec3<double> point) const {
    point[axis] = 2 * middle - point[axis];
    return point;
  }
};

/// The symmetry across an axis, of vertices up to rounding; nothing where a vertex has no mirror image.
std::optional<MirrorSymmetry> mirror_symmetry(const std::vector<Vec3<double>>& vertices, int axis);

/// Whether the mirror image of every element, which turns the other way round, is an element.
bool keeps(const MirrorSymmetry& mirror, const CageElements& elements);

/// Makes positions of vertices symmetric: each becomes the mean of its own and of its mirror image's, mirrored.
std::vector<Vec3<double>> made_symmetric(const MirrorSymmetry& mirror, const std::vector<Vec3<double>>& vertices);

}  // namespace cageproof::validation
