// SPDX-License-Identifier: MIT
#include "sampling/generic_change.h"

#include "run/fingerprint.h"

#include "cageproof/core/numbers/random_stream.h"

#include <fmt/format.h>

namespace cageproof::validation {

std::vector<Vec3<double>> generic_change(const Cage& cage) {
  std::vector<Vec3<double>> change(cage.vertices().size(), Vec3<double>::Zero());
  const std::string stream = fmt::format("change/{}", drawn_by(cage));
  for (std::size_t v = 0; v < change.size(); ++v) {
    RandomStream random(0, stream, v);
    for (int c = 0; c < cage.dimension(); ++c) change[v][c] = cage.size() * random.uniform(-1, 1);
  }
  return change;
}

}  // namespace cageproof::validation
