// SPDX-License-Identifier: MIT
// Rotations that permute the axes with signs, so that a turned input is exact.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <vector>

namespace cageproof::validation {

/// A rotation of space, or of the plane in itself.
class Turn {
 public:
  /// \param dim 2: a quarter turn, which keeps the third coordinate; 3: (x, y, z) -> (y, -z, -x)
  explicit Turn(int dim) : dim_(dim), row_(table[dim - 2]) {}

  Vec3<double> operator()(const Vec3<double>& v) const {
    const auto& [source, sign] = row_;
    return {sign[0] * v[source[0]], sign[1] * v[source[1]], sign[2] * v[source[2]]};
  }

  /// Tensors in the turned axes as they are in the first ones.
  /// \param tensors one after the other, each with `indices` indices that run over space, the last the fastest
  std::vector<double> undo(const std::vector<double>& tensors, int indices) const {
    const auto& [source, sign] = row_;
    std::size_t span = 1;
    for (int i = 0; i < indices; ++i) span *= dim_;
    std::vector<double> plain(tensors.size());
    for (std::size_t at = 0; at < tensors.size(); ++at) {
      std::size_t target = 0, rest = at % span, weight = 1;
      double factor = 1;
      for (int i = 0; i < indices; ++i, rest /= dim_, weight *= dim_) {
        target += weight * source[rest % dim_];
        factor *= sign[rest % dim_];
      }
      plain[at - at % span + target] = factor * tensors[at];
    }
    return plain;
  }

 private:
  // New axis i takes old axis source[i] with sign[i]; determinant one.
  struct Row {
    std::array<int, 3> source;
    std::array<double, 3> sign;
  };
  static constexpr std::array<Row, 2> table{Row{{1, 0, 2}, {-1, 1, 1}}, Row{{1, 2, 0}, {1, -1, -1}}};

  std::size_t dim_;
  Row row_;
};

}  // namespace cageproof::validation
