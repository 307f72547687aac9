// SPDX-License-Identifier: MIT
// Functions that make tables of coordinates for blocks, and multiply them with cage data.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof {

/// Returns one table per block for this many points, set to zero.
template <Scalar R>
std::vector<CoordinateTable<R>> zero_tables(const std::vector<CoordinateBlock>& blocks, int dimension,
                                            std::size_t points, int order) {
  std::vector<CoordinateTable<R>> tables(blocks.size());
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      tables[b].stride[o] =
          static_cast<std::size_t>(blocks[b].size) * blocks[b].entries() * derivative_count(dimension, o);
      tables[b].tensors[o].assign(points * tables[b].stride[o], R(0));
    }
  return tables;
}

/// Adds one point's coordinates of a block times their data.
/// \param coordinates [coordinate][row][column][derivative] \param data [coordinate][column][set]
/// \param derivatives how many, derivative_count \param to [row][set][derivative]
inline void add_products(std::span<const double> coordinates, const CoordinateBlock& block,
                         std::span<const double> data, int sets, std::size_t derivatives, std::span<double> to) {
  const double* from = coordinates.data();
  for (int c = 0; c < block.size; ++c)
    for (int row = 0; row < block.shape.rows; ++row)
      for (int column = 0; column < block.shape.columns; ++column, from += derivatives)
        for (int set = 0; set < sets; ++set) {
          const double x = data[(c * block.shape.columns + column) * sets + set];
          for (std::size_t i = 0; i < derivatives; ++i) to[(row * sets + set) * derivatives + i] += x * from[i];
        }
}

}  // namespace cageproof
