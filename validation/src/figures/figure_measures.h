// SPDX-License-Identifier: MIT
// Measures that captions of figures state.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <vector>

namespace cageproof::validation {

/// How far images are from being symmetric in x, where the points are: the largest distance between the image of a
/// point's mirror image and the mirror image of its image. \throws std::invalid_argument for points that are not
/// symmetric
double asymmetry(const std::vector<Vec3<double>>& points, const std::vector<Vec3<double>>& images);

}  // namespace cageproof::validation
