// SPDX-License-Identifier: MIT
// Coordinates in float are computed in double and rounded.
#pragma once

#include "cageproof/core/coordinates/prepared_coordinates.h"

#include <algorithm>
#include <vector>

namespace cageproof {

/// \param compute fills tables in double: (points, tables)
template <class Compute>
void compute_in_double(std::span<const Vec3<float>> points, std::span<CoordinateTable<float>> tables, Compute compute) {
  std::vector<Vec3<double>> wide_points;
  for (const Vec3<float>& point : points) wide_points.push_back(convert<double>(point));
  std::vector<CoordinateTable<double>> wide(tables.size());
  for (std::size_t b = 0; b < tables.size(); ++b) {
    wide[b].stride = tables[b].stride;
    for (std::size_t o = 0; o < 3; ++o) wide[b].tensors[o].assign(tables[b].tensors[o].size(), 0.0);
  }
  compute(std::span<const Vec3<double>>(wide_points), std::span<CoordinateTable<double>>(wide));
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (std::size_t o = 0; o < 3; ++o)
      std::ranges::transform(wide[b].tensors[o], tables[b].tensors[o].begin(),
                             [](double x) { return static_cast<float>(x); });
}

/// CoordinatesFromDouble with float, which is computed in double and rounded.
template <class Derived>
class CoordinatesInDouble : public CoordinatesFromDouble<Derived> {
 public:
  using CoordinatesFromDouble<Derived>::fill;
  void fill(std::span<const Vec3<float>> points, int order, std::span<CoordinateTable<float>> tables) const override {
    compute_in_double(points, tables, [&](auto wide, auto in_double) { fill(wide, order, in_double); });
  }
};

}  // namespace cageproof
