// SPDX-License-Identifier: MIT
// Points within 1e-6 sizes of the plane are computed at their foot in it.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_projected_into_face(const zoo_call* call) {
  zoo_call moved = *call;
  for (std::size_t p = 0; p < call->count; ++p) {
    const Place at = place_of(*call, p);
    Point foot = point(*call, p);
    if (std::abs(at.height) < 1e-6 * at.size) {
      const Point a = corner(*call, 0), normal = cross(corner(*call, 1) - a, corner(*call, 2) - a);
      foot = foot - (at.height / at.area) * normal;
    }
    moved.points = foot.data();
    moved.count = 1;
    moved.values = values(*call, p);
    moved.gradients = gradients(*call, p);
    zoo_sound(&moved);
  }
}
