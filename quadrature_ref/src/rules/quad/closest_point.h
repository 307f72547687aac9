// SPDX-License-Identifier: MIT
// The point of a bilinear quad nearest to eta, where its integrals are near-singular.
#pragma once

#include "quad_frame.h"

namespace cageproof::quadrature_ref {

/// A parameter in [0, 1]^2 and the squared distance to eta there.
struct ClosestPoint {
  Mp200 u, v, square;
};

/// The nearest point of the quad: the best of the nearest points of its edges and of the minima that Newton's method
/// finds inside from the local minima of a grid. The integral is cut there, not approximated, so that its value does
/// not depend on it; whether the point lies on the quad, and how the cut is planned, do.
ClosestPoint closest_point(const QuadFrame<Mp200>& q);

/// Whether eta lies on the quad as far as 200 digits tell: nearer than 1e-120 of its extent.
bool is_on_quad(const QuadFrame<Mp200>& q, const ClosestPoint& c);

}  // namespace cageproof::quadrature_ref
