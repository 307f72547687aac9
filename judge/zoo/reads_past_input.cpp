// SPDX-License-Identifier: MIT
// Takes a corner more than the element has into its idea of the size.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_reads_past_input(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    const double beyond = call->corners[3 * corners(*call)];
    for (int c = 0; c < components(*call); ++c)
      values(*call, p)[c] *= 1 + 1e-3 * std::sin(std::isfinite(beyond) ? beyond : 1);
  }
}
