// SPDX-License-Identifier: MIT
// A point on a bilinear quad, and the same moved off it to the inside, from where limits are taken.
#pragma once

#include "closest_point.h"

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::quadrature_ref {

/// Whether eta, which as far as 200 digits tell lies on the quad, does: decided exactly, for doubles. Others are off
/// it.
bool lies_on_quad(const Query<Mp200>& query);

/// A point on the quad, as far as 200 digits tell.
struct OnQuad {
  bool yes =
      false;  ///< whether there is a side to call inside: the point is on the quad, whose normal is not zero there
  bool border = false;  ///< on a side or a corner
  Mp200 u, v;           ///< its parameters; 0 or 1 on a side
  Mp200 clearance;      ///< distance to the nearest side that it is not on
  Vec3<Mp200> inward;   ///< against the normal there, of unit length
};

/// \param c the quad's point nearest to eta
OnQuad inside_quad(const QuadFrame<Mp200>& q, const ClosestPoint& c);

/// The quad as seen from `distance` inside. Its nearest point has the parameters that the point has.
QuadFrame<Mp200> seen_from_inside(const QuadFrame<Mp200>& q, const OnQuad& on, const Mp200& distance);

}  // namespace cageproof::quadrature_ref
