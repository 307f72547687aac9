// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation {

/// Distance of a point to the segment from a to b, in the plane or in space.
double distance_to_segment(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b);

}  // namespace cageproof::validation
