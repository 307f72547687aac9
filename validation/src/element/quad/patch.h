// SPDX-License-Identifier: MIT
// A bilinear quad as a surface in space: distance to it, and where a ray meets it.
#pragma once

#include "cageproof/core/geometry/element.h"

namespace cageproof::validation {

/// A lower bound of the distance of a point to a bilinear quad, at most 0.1 % below it (or 1e-15 of the quad's size,
/// next to it). \param enough the answer may be any bound above this
double distance_to_quad(const Vec3<double>& point, const Quad<double>& q, double enough);

/// How often a ray meets a bilinear quad, or -1 where it comes too close to the border or grazes: another ray should be
/// asked.
int crossings_of_quad(const Vec3<double>& origin, const Vec3<double>& direction, const Quad<double>& q);

}  // namespace cageproof::validation
