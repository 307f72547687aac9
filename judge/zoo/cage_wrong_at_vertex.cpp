// SPDX-License-Identifier: MIT
// A column that is never set where a point is a vertex.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_cage_wrong_at_vertex(const zoo_cage* cage) {
  zoo_mean_value(cage, [](const double*, const double*, const double* basis, double* weights) {
    for (int k = 0; k < 3; ++k)
      if (basis[k] == 1) weights[k] = 0;
  });
}
