// SPDX-License-Identifier: MIT
// Values times a factor that depends on the point, and falls out where they are divided by their sum.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_right_after_normalising(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const double factor =
        1 / (1 + norm(point(*call, p) - corner(*call, 0)) / norm(corner(*call, 1) - corner(*call, 0)));
    for (int c = 0; c < components(*call); ++c) values(*call, p)[c] *= factor;
  }
}
