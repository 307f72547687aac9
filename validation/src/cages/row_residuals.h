// SPDX-License-Identifier: MIT
// How far a row of values is from what coordinates must give, for many rows.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::validation {

struct Residuals {
  bool has_nan = false, has_infinity = false;  ///< among the values; errors are not looked at then
  double partition = 0;                        ///< |sum - expected|
  double reproduction = 0;                     ///< |sum times vertices and normals - expected point|, in cage sizes
};

/// Partition of unity and linear reproduction as errors_of() has them for order 0, without tensors a coordinate: what
/// columns multiply is prepared once.
class RowResiduals {
 public:
  /// \param per_value numbers of a value and its derivatives
  RowResiduals(const CageCoordinates& coordinates, const Cage& cage, std::size_t per_value);

  /// \param row block by block; in a block all values, then all derivatives
  /// \param expected sum of the coordinates
  Residuals of(std::span<const double> row, const Vec3<double>& point, double expected) const;

 private:
  struct Block {
    std::size_t first, size;  // columns of values
    int entries;              // of a coordinate
    Reproduces reproduces;
    std::array<std::vector<double>, 3> data;  // by axis: what coordinates multiply, of turned vertices turned
  };

  int dimension_;
  double size_;
  std::vector<Block> blocks_;
};

}  // namespace cageproof::validation
