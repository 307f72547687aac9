// SPDX-License-Identifier: MIT
// Weights that are wrong, projected until they sum to one.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_cage_sum_made_right(const zoo_cage* cage) {
  zoo_mean_value(cage, nullptr);
  for (std::size_t p = 0; p < cage->count; ++p) {
    double* const w = cage->coordinates + p * cage->vertex_count;
    w[0] += 0.1 * w[1];
    w[1] -= 0.1 * w[1];
  }
}
