// SPDX-License-Identifier: MIT
// How far coordinates are from those of a second route.
#pragma once

#include "second_routes/cage_routes.h"

namespace cageproof::validation {

/// Of values in 100 digits, relative, norm-wise over all vertices: roundings hide nothing there. NaN where either has
/// no coordinates.
double second_route_error_at(const CageCoordinates& coordinates, const second_routes::CageRoute& route,
                             const Vec3<double>& point);

}  // namespace cageproof::validation
