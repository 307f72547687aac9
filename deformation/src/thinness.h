// SPDX-License-Identifier: MIT
// Cages whose elements are of several sizes at one place.
#pragma once

#include "cageproof/core/cage/cage_elements.h"

#include <string>

namespace cageproof::deformation {

/// How thin a cage is, and where.
struct Thinness {
  double times = 1;         ///< roundings of derivatives at samples grow like its square
  std::size_t element = 0;  ///< the thinnest
  std::string what;         ///< of the element, to be said behind its name
};

/// In space the thinnest element: its longest side over its height. In the plane, where elements have no height, the
/// longest edge over the shortest, or over the distance of a vertex from an edge that it is no end of, as of a bar, a
/// notch or a sharp corner.
Thinness thinness_of(const CageElements& elements);

/// The element with the shortest edge, as often as it goes into the longest.
Thinness smallness_of(const CageElements& elements);

}  // namespace cageproof::deformation
