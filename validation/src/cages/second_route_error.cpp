// SPDX-License-Identifier: MIT
#include "cages/second_route_error.h"

namespace cageproof::validation {
namespace {

template <class R>
second_routes::Blocks values_at(const CageCoordinates& coordinates, const Vec3<double>& point) {
  second_routes::Blocks found;
  for (const Result<R>& block : coordinates.at<R>(convert<R>(point), 0))
    found.emplace_back(block.value.begin(), block.value.end());
  return found;
}

}  // namespace

double second_route_error_at(const CageCoordinates& coordinates, const second_routes::CageRoute& route,
                             const Vec3<double>& point) {
  const bool in_50 = route.compared_in() == ScalarKind::Digits50;
  return route.error_at(point, in_50 ? values_at<Mp50>(coordinates, point) : values_at<Mp100>(coordinates, point));
}

}  // namespace cageproof::validation
