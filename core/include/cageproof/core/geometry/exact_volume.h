// SPDX-License-Identifier: MIT
// The height of a point over a triangle's plane, times twice its area, computed exactly and rounded.
#pragma once

#include "cageproof/core/geometry/element.h"

namespace cageproof {

/// ((t1 - t0) x (t2 - t1)) . (t0 - point), rounded as once; zero only where it is zero, or below double's range. Of any
/// finite doubles; quick within 112 bits. \param exponent lengths are in units of two to this power
double exact_volume(const Triangle<double>& t, const Vec3<double>& point, int exponent);

}  // namespace cageproof
