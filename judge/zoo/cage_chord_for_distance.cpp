// SPDX-License-Identifier: MIT
// On faces, chords of the unit sphere stand where distances belong.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_cage_chord_for_distance(const zoo_cage* cage) {
  zoo_mean_value(cage, [](const double* corners, const double* point, const double* basis, double* weights) {
    if (basis[0] * basis[1] * basis[2] == 0) return;  // edges and corners are right
    const Point eta{point[0], point[1], point[2]};
    std::array<Point, 3> unit{};
    for (int k = 0; k < 3; ++k) {
      const Point to = Point{corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]} - eta;
      unit[static_cast<std::size_t>(k)] = (1 / norm(to)) * to;
    }
    const std::array<double, 3> chord{norm(unit[1] - unit[2]), norm(unit[2] - unit[0]), norm(unit[0] - unit[1])};
    for (std::size_t k = 0; k < 3; ++k)
      weights[k] = std::sin(2 * std::asin(chord[k] / 2)) * chord[(k + 1) % 3] * chord[(k + 2) % 3];
  });
}
