// SPDX-License-Identifier: MIT
// Faces of any number of corners as triangles.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof {

/// The triangles of a face, by corner, turned as it is and cut as cages are: a quad along the shorter diagonal, or the
/// other one where that folds it; more corners in ears of the shortest diagonal first. \param corners three or more,
/// finite \returns nothing where a boundary of more than four corners crosses or touches itself or has no area, seen
/// along the coordinate axis that its area is largest on
std::vector<std::array<int, 3>> triangles_of_face(std::span<const Vec3<double>> corners);

}  // namespace cageproof
