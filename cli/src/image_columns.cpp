// SPDX-License-Identifier: MIT
#include "image_columns.h"

#include <fmt/format.h>

#include <array>

namespace cageproof::cli {
namespace {

constexpr std::array axes{"x", "y", "z"};

// Names and groups.
CoordinateColumns headed(int dimension, int order) {
  CoordinateColumns table;
  static constexpr std::array labels{"image", "image gradient", "image Hessian"};
  for (int o = 0; o <= order; ++o) {
    const std::size_t before = table.names.size();
    for (int c = 0; c < dimension; ++c) {
      if (o == 0) table.names.emplace_back(axes[c]);
      for (int i = 0; o >= 1 && i < dimension; ++i) {
        if (o == 1) table.names.push_back(fmt::format("{}_d{}", axes[c], axes[i]));
        for (int j = 0; o == 2 && j < dimension; ++j)
          table.names.push_back(fmt::format("{}_d{}{}", axes[c], axes[i], axes[j]));
      }
    }
    table.groups.push_back({labels[o], table.names.size() - before});
  }
  return table;
}

}  // namespace

CoordinateColumns image_columns(const deformation::Images<double>& images, int dimension, int order) {
  CoordinateColumns table = headed(dimension, order);
  const std::size_t points = images.tensors[0].size() / dimension;
  table.values.reserve(points * table.names.size());
  for (std::size_t p = 0; p < points; ++p)
    for (int o = 0; o <= order; ++o) {
      const auto width = static_cast<std::ptrdiff_t>(table.groups[o].columns);
      const auto row = images.tensors[o].begin() + static_cast<std::ptrdiff_t>(p) * width;
      table.values.insert(table.values.end(), row, row + width);
    }
  return table;
}

}  // namespace cageproof::cli
