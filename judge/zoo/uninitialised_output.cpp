// SPDX-License-Identifier: MIT
// Leaves the output as it is for points over the element's first half.
#include "sound.h"

#include <vector>

using namespace cageproof::zoo;

extern "C" void zoo_uninitialised_output(const zoo_call* call) {
  std::vector<double> before(call->values, call->values + call->count * static_cast<std::size_t>(components(*call)));
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    if (norm(point(*call, p) - corner(*call, 0)) < norm(point(*call, p) - corner(*call, 1)))
      values(*call, p)[0] = before[p * static_cast<std::size_t>(components(*call))];
}
