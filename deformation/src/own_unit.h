// SPDX-License-Identifier: MIT
// Units of length that are a cage's own.
#pragma once

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/cage/cage_elements.h"

#include <cmath>

namespace cageproof::deformation {

/// The diagonal of the rest vertices' box.
inline double size_of(const CageElements& elements) {
  const auto [low, high] = box_of(elements.vertices());
  return (high - low).stableNorm();
}

/// The power of two at or below a length: dividing by it rounds nothing.
inline double unit_next_to(double length) { return std::exp2(std::ilogb(length)); }

}  // namespace cageproof::deformation
