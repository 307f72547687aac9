// SPDX-License-Identifier: MIT
#include "cages/second_route_error.h"

namespace cageproof::validation {

double second_route_error_at(const CageCoordinates& coordinates, const second_routes::CageRoute& route,
                             const Vec3<double>& point) {
  const std::vector<Mp100> found = coordinates.at<Mp100>(convert<Mp100>(point), 0).front().value;
  const std::vector<Mp100> expected = route(point);
  Mp100 error = 0, size = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mp100 difference = found[i] - expected[i];
    error += difference * difference;
    size += expected[i] * expected[i];
  }
  return static_cast<double>(Mp100(sqrt(Mp100(error / size))));
}

}  // namespace cageproof::validation
