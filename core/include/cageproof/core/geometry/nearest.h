// SPDX-License-Identifier: MIT
// The place of an element that is nearest to a point, rounded.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <span>

namespace cageproof {

/// A place on an element: its corners' basis functions there (hat functions, of a quad bilinear ones), and the place.
struct NearestPlace {
  std::array<double, 4> basis{};
  Vec3<double> place = Vec3<double>::Zero();
};

/// In double, to a few roundings of the element's size and distance, in any unit; of a quad the bilinear surface's
/// nearest place by Newton's method, whose distance may exceed the least one where several places are about as near.
/// \param corners of a segment, a triangle or a quad, which have a length or an area
NearestPlace nearest_place(std::span<const Vec3<double>> corners, const Vec3<double>& point);

}  // namespace cageproof
