// SPDX-License-Identifier: MIT
// A bilinear quad as a surface in space: distance to it.
#pragma once

#include "cageproof/core/geometry/element.h"

namespace cageproof::validation {

/// A lower bound of the distance of a point to a bilinear quad, at most 0.1 % below it (or 1e-15 of the quad's size,
/// next to it). \param enough the answer may be any bound above this
double distance_to_quad(const Vec3<double>& point, const Quad<double>& q, double enough);

}  // namespace cageproof::validation
