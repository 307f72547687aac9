// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"

#include <algorithm>

namespace cageproof {

void BesideSums::fill(std::span<const Vec3<float>> points, int order, std::span<CoordinateTable<float>> tables) const {
  compute_in_double(points, tables, [&](auto wide, auto in_double) { fill(wide, order, in_double); });
}

void BesideSums::fill_with_sums(std::span<const Vec3<double>> points, int order,
                                std::span<CoordinateTable<double>> tables) const {
  for (CoordinateTable<double>& table : tables)
    for (std::vector<double>& tensor : table.tensors) std::ranges::fill(tensor, 0.0);
  summed_->fill(points, order, tables);
}

std::vector<CoordinateTable<double>> BesideSums::sums_at(const Vec3<double>& point, int order) const {
  auto tables = zero_tables<double>(blocks(), dimension_, 1, order);
  summed_->fill(std::span(&point, 1), order, tables);
  return tables;
}

}  // namespace cageproof
