// SPDX-License-Identifier: MIT
// The gradients of an element's stretch by its posed corners.
#pragma once

#include "turns.h"

#include "cageproof/deformation/stretch.h"

#include <array>

namespace cageproof::deformation {

/// Slopes of stretch_of(), one per corner of the element, the rest zero. \throws InputError, naming the element, where
/// it has none
template <Scalar R>
std::array<Vec3<R>, 4> stretch_gradients(Stretch stretch, const CageElements& rest,
                                         const std::vector<Vec3<R>>& vertices, const NormalPlace& at);

}  // namespace cageproof::deformation
