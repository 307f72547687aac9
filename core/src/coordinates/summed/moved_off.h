// SPDX-License-Identifier: MIT
// Points so near to a cage that 200 digits do not hold what derivatives of normalised weights cancel, seen from further
// off, where they are the same up to 1e-20: mean value coordinates are smooth up to a face, and next to an edge or a
// vertex they are linear in the distance, for each direction, so that gradients stay and Hessians are over the
// distance.
#pragma once

#include "cageproof/core/numbers/mp.h"
#include "cageproof/core/numbers/vector.h"

#include <vector>

namespace cageproof {

struct MovedOff {
  Vec3<Mp200> point;
  Mp200 further = 1;  ///< how many times the Hessian there that of the point is
};

/// Off the flat elements that a point is next to, which it does not touch.
/// \param elements corners of each, three in space, two in the plane
MovedOff moved_off(const std::vector<std::vector<Vec3<Mp200>>>& elements, const Vec3<Mp200>& point);

}  // namespace cageproof
