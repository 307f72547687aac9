// SPDX-License-Identifier: MIT
// Measures that captions of figures state.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <vector>

namespace cageproof::validation {

/// How far images are from being symmetric in x, where the points are: the largest distance between the image of a
/// point's mirror image and the mirror image of its image. \throws std::invalid_argument for points that are not
/// symmetric
double asymmetry(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images);

/// The largest distance between two images of a point. \pre as many of both
double largest_distance(const std::vector<Vec3<double>>& images, const std::vector<Vec3<double>>& others);

/// By how many degrees, at most, a map sharpens the edge between two faces: the angle between their normals there, less
/// that at rest, largest over all edges, and at least 0. Zero for rigid maps and similarities. A face without area in
/// the image counts as one that is turned by 180 degrees.
double added_turn(const std::vector<std::vector<int>>& faces, const std::vector<Vec3<double>>& points,
                  const std::vector<Vec3<double>>& images);

/// The share of a step that each point takes along it: the sum of the coordinates of the cage's vertices that take it,
/// where the others stay and coordinates reproduce affine maps. One per point. \pre the step is not zero
std::vector<double> shares_of_step(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images,
                                   const Vec3<double>& step);

}  // namespace cageproof::validation
