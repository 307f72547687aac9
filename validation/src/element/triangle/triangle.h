// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation {

/// Distance of a point to a triangle.
double distance_to_triangle(const Vec3<double>& point, const Triangle<double>& t);

}  // namespace cageproof::validation
