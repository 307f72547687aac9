// SPDX-License-Identifier: MIT
// How far coordinates are from those of a second route.
#pragma once

#include "second_routes/cage_routes.h"

namespace cageproof::validation {

/// Error of the values in the route's scalar, in which roundings hide nothing. NaN where either has no coordinates.
double second_route_error_at(const CageCoordinates& coordinates, const second_routes::CageRoute& route,
                             const Vec3<double>& point);

}  // namespace cageproof::validation
