// SPDX-License-Identifier: MIT
// Spherical mean value coordinates (Langer, Belyaev, Seidel 2006) as they are defined: integrals over spherical
// polygons and over the directions around a point of the sphere, by quadrature.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/numbers/linear.h"

#include <span>
#include <vector>

namespace cageproof::second_routes {

/// The integral of x over the spherical polygon with these unit corners: over the fan of signed spherical triangles
/// from an axis, in polar coordinates about it, the radius first. Nothing is taken from the arcs' own closed formula.
Vec3<Mp100> mean_vector(std::span<const Vec3<Mp100>> corners);

/// Shares T_i of corners in directions e_i around a point of the sphere: the integral over all directions, each
/// written as a combination of the two e_i that it lies between. Then sum T_i e_i is the integral of all directions,
/// zero. \param tangents unit vectors orthogonal to the axis
std::vector<Mp100> shares_of_directions(std::span<const Vec3<Mp100>> tangents, const Vec3<Mp100>& axis);

/// The coordinates of a point off the cage, one per vertex; NaN where a face's mean vector lies on one of its arcs.
std::vector<Mp100> spherical_coordinates(const Cage& cage, const Vec3<double>& point);

}  // namespace cageproof::second_routes
