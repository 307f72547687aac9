// SPDX-License-Identifier: MIT
// Positive mean value coordinates as Lipman, Kopf, Cohen-Or, Levin 2007 compute them: by what a cube map shows.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/numbers/vector.h"

#include <vector>

namespace cageproof::second_routes {

/// Rays per side of the cube's six faces: errors fall like one over it where faces hide others.
inline constexpr int rays_per_side = 96;

/// The coordinates of a point inside, one per vertex: the mean over all directions of the first triangle's hat
/// functions over the distance, each ray for the solid angle of its pixel. In double.
std::vector<double> coordinates_of_rays(const Cage& cage, const Vec3<double>& point);

}  // namespace cageproof::second_routes
