// SPDX-License-Identifier: MIT
#include "cage_routes.h"

#include "spherical_route.h"

namespace cageproof::second_routes {

CageRoute cage_route(const CoordinateKind& kind, const Cage& cage) {
  if (kind.name == "spherical_mean_value")
    return [&cage](const Vec3<double>& point) { return spherical_coordinates(cage, point); };
  return {};
}

}  // namespace cageproof::second_routes
