// SPDX-License-Identifier: MIT
// Sound: the matrices by columns.
#include "sound.h"

#include <algorithm>
#include <utility>

using namespace cageproof::zoo;

extern "C" void zoo_transposed(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for (int m = 0; m < components(*call); m += 9)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) {
          std::swap(values(*call, p)[m + 3 * i + j], values(*call, p)[m + 3 * j + i]);
          if (double* const g = gradients(*call, p))
            std::swap_ranges(g + 3 * (m + 3 * i + j), g + 3 * (m + 3 * i + j) + 3, g + 3 * (m + 3 * j + i));
        }
}
