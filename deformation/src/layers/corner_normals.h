// SPDX-License-Identifier: MIT
// Posed normals that bend with the cage: one at each corner of each element.
#pragma once

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// Data for [T24] Eq 41, n_t^k: the rest normal of element t turned by the rotation of its k-th vertex, and stretched
/// as the element is. The paper leaves open which normals are meant. A vertex's rotation is the one nearest to the sum
/// of its elements' rotations, weighted with rest areas or lengths ([C23] Section 4.2), so that poses by rotations have
/// constant normals. One row per corner, element by element.
/// \param warnings takes vertices whose rotation is not unique
/// \throws InputError for an element without area or length
template <Scalar R>
std::vector<Vec3<R>> corner_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                                    std::vector<std::string>& warnings);

}  // namespace cageproof::deformation
