// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/results/run_result.h"

#include <vector>

namespace cageproof::reports {

/// Where a surface, or polygon in the plane, meets the plane on which a coordinate has a value: segments in space.
/// Faces of four corners are taken as bilinear; of one that lies in the plane, its edges.
/// \param axis 0, 1 or 2
std::vector<std::array<Vec3<double>, 2>> outline_in_plane(const MeshField& surface, int axis, double value);

}  // namespace cageproof::reports
