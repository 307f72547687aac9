// SPDX-License-Identifier: MIT
// Corners whose coordinates have as many bits as doubles hold, though points between them are exact: multiples of a
// common power of two.
#pragma once

#include "draws.h"

#include <array>

namespace cageproof::validation {

/// Spacing of the grid on which all coordinates lie. Below 8 their sums are exact.
inline constexpr double grid_spacing = 0x1p-49;

/// Whether a sample of an on-regime has coordinates of many bits; of few, in 64ths, by turns.
inline bool has_many_bits(std::uint64_t index) { return index / 2 % 2 == 1; }

inline double random_on_grid(RandomStream& random, double half, double spacing) {
  return spacing * std::nearbyint(random.uniform(-half, half) / spacing);
}

/// Steps that span a line (in the plane) or a plane (in space), by turns of any direction, along axes, or along vectors
/// of small integers, whose lines and planes hold points of any coordinates on the grid.
class GridSteps {
 public:
  GridSteps(RandomStream& random, int dim, std::uint64_t turn) : any_(turn % 3 == 0), dim_(dim) {
    const int count = dim - 1, first = random.below(dim);
    for (int k = 0; k < count; ++k) along_[k] = unit_along((first + k) % dim);
    if (turn % 3 != 2) return;
    do {
      for (int k = 0; k < count; ++k) along_[k] = random_integers(random, 2, dim);
    } while (!(along_[0].squaredNorm() > 0) || (count == 2 && !(along_[0].cross(along_[1]).squaredNorm() > 0)));
  }
  /// Coordinates are multiples of `spacing`.
  Vec3<double> draw(RandomStream& random, double spacing) const {
    Vec3<double> step = Vec3<double>::Zero();
    for (int c = 0; any_ && c < dim_; ++c) step[c] = random_on_grid(random, 1, spacing);
    for (int k = 0; !any_ && k + 1 < dim_; ++k) step += random_on_grid(random, 1, spacing) * along_[k];
    return step;
  }

 private:
  bool any_;
  int dim_;
  std::array<Vec3<double>, 2> along_{Vec3<double>::Zero(), Vec3<double>::Zero()};
};

/// A point within half a unit of the origin.
inline Vec3<double> random_origin_on_grid(RandomStream& random, int dim) {
  Vec3<double> v = Vec3<double>::Zero();
  for (int c = 0; c < dim; ++c) v[c] = random_on_grid(random, 0.5, grid_spacing);
  return v;
}

}  // namespace cageproof::validation
