// SPDX-License-Identifier: MIT
#include "cageproof/validation/second_route.h"

#include "second_routes/cage_routes.h"

namespace cageproof::validation {

SecondRoute second_route_of(const CoordinateKind& kind, const Cage& cage) {
  const auto route = second_routes::cage_route(kind, cage);
  if (!route) return {};
  return [route](const Vec3<double>& point, const std::vector<std::vector<Mp100>>& blocks) {
    return route->error_at(point, blocks);
  };
}

}  // namespace cageproof::validation
