// SPDX-License-Identifier: MIT
// Measures of maps of the plane that captions of figures state.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <optional>
#include <vector>

namespace cageproof::validation {

/// The largest distance between images of points on a polygon's border and the places where its pose puts these, edges
/// staying straight and evenly stretched. Points count as on the border up to 1e-5 of the cage's size. Nothing where
/// no point is.
std::optional<double> miss_of_cage(const Cage& cage, const std::vector<Vec3<double>>& posed,
                                   const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images);

/// The share of triangles, two per quad, that are turned over: 0 for maps that may be one to one, above 0 for those
/// that are not. \pre faces are counter-clockwise at rest
double folded_share(const std::vector<std::vector<int>>& faces, const std::vector<Vec3<double>>& images);

/// By how many degrees an angle between two directions changes at most where a map has these derivatives by x and y:
/// twice the arc sine of (a - b) / (a + b), a and b its singular values (Tissot). 180 where it turns the plane over.
double angle_change(const Vec3<double>& by_x, const Vec3<double>& by_y);

}  // namespace cageproof::validation
