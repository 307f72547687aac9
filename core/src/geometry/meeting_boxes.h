// SPDX-License-Identifier: MIT
// Which boxes meet, among many: the first sieve before exact decisions.
#pragma once

#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace cageproof {

/// Calls `with` once for each pair of boxes that have a point in common, borders included, by their indices, the lower
/// one first, in ascending order, until it returns false.
/// \param boxes of finite corners
void for_meeting_boxes(const std::vector<Eigen::AlignedBox3d>& boxes, const std::function<bool(int, int)>& with);

}  // namespace cageproof
