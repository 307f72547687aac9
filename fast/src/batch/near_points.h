// SPDX-License-Identifier: MIT
// An order of points in which neighbours are near each other, so that a block of them sees faces alike.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cageproof::closed_form::batch {

/// Numbers of the points along a curve that fills their box (Morton 1966); points that are no numbers come first.
std::vector<std::size_t> along_a_curve(std::span<const Vec3<double>> points);

}  // namespace cageproof::closed_form::batch
