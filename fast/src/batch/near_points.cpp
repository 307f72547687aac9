// SPDX-License-Identifier: MIT
#include "near_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace cageproof::closed_form::batch {
namespace {

// Cells of the box along each side: 2^10.
constexpr int kCellBits = 10;

// Ten bits with two zeros after each.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

}  // namespace

std::vector<std::size_t> along_a_curve(std::span<const Vec3<double>> points) {
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const Vec3<double>& p : points)
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(p[i])) continue;
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  // Halves, because a box may be wider than double's range.
  double side = 0;
  for (int i = 0; i < 3; ++i) side = std::max(side, high[i] / 2 - low[i] / 2);
  constexpr double cells = 1 << kCellBits;
  std::vector<std::pair<std::uint32_t, std::size_t>> placed;
  placed.reserve(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::uint32_t key = 0;
    for (int i = 0; i < 3; ++i) {
      const double cell = std::floor((points[p][i] / 2 - low[i] / 2) / side * cells);
      // A coordinate that is no number has no cell.
      if (cell >= 0) key |= spread(static_cast<std::uint32_t>(std::min(cell, cells - 1))) << i;
    }
    placed.emplace_back(key, p);
  }
  std::ranges::sort(placed);
  std::vector<std::size_t> order;
  order.reserve(points.size());
  for (const auto& [key, p] : placed) order.push_back(p);
  return order;
}

}  // namespace cageproof::closed_form::batch
