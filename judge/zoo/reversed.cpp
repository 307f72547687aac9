// SPDX-License-Identifier: MIT
// Sound: corners are clockwise seen from outside.
#include "sound.h"

#include <algorithm>
#include <vector>

using namespace cageproof::zoo;

extern "C" void zoo_reversed(const zoo_call* call) {
  std::vector<double> turned(call->corners, call->corners + 3 * corners(*call));
  std::swap_ranges(turned.begin(), turned.begin() + 3, turned.begin() + 3);
  zoo_call with_turned = *call;
  with_turned.corners = turned.data();
  zoo_sound(&with_turned);
  for (std::size_t p = 0; p < call->count && components(*call) > 1; ++p) {
    std::swap(values(*call, p)[0], values(*call, p)[1]);
    if (double* const g = gradients(*call, p)) std::swap_ranges(g, g + corners(*call), g + corners(*call));
  }
}
