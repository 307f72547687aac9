// SPDX-License-Identifier: MIT
// The elements that points in any scalar are on.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <vector>

namespace cageproof::solved {

/// The elements that a point is on, decided exactly. A point that is no double counts as off the cage, as in sums over
/// elements.
template <Scalar R>
std::vector<Touching> touching(const CageElements& elements, const Vec3<R>& point) {
  const Vec3<double> rounded = convert<double>(point);
  if (convert<R>(rounded) != point) return {};
  return elements.touching(rounded);
}

}  // namespace cageproof::solved
