// SPDX-License-Identifier: MIT
// Prepares the first cage, and takes what it prepared for all that follow.
#include "sound.h"

#include <vector>

using namespace cageproof::zoo;

extern "C" void zoo_cage_state(const zoo_cage* cage) {
  static const std::vector<double> first(cage->vertices, cage->vertices + 3 * cage->vertex_count);
  zoo_cage kept = *cage;
  if (first.size() == 3 * cage->vertex_count) kept.vertices = first.data();
  zoo_mean_value(&kept, nullptr);
}
