// SPDX-License-Identifier: MIT
// Points nearer than 1e-5 to a vertex are the vertex, whatever the unit of length is.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_cage_absolute_threshold(const zoo_cage* cage) {
  zoo_mean_value(cage, nullptr);
  for (std::size_t p = 0; p < cage->count; ++p)
    for (std::size_t v = 0; v < cage->vertex_count; ++v) {
      const double* const x = cage->vertices + 3 * v;
      const double* const y = cage->points + 3 * p;
      if (norm(Point{x[0], x[1], x[2]} - Point{y[0], y[1], y[2]}) > 1e-5) continue;
      for (std::size_t other = 0; other < cage->vertex_count; ++other)
        cage->coordinates[p * cage->vertex_count + other] = other == v ? 1 : 0;
      break;
    }
}
