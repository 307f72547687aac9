// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace cageproof::reports {

/// Viridis at equal steps: even in lightness, also for people who see few colours and in grey print.
inline constexpr std::array<const char*, 9> kPalette{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                                     "#28ae80", "#5ec962", "#addc30", "#fde725"};

/// Red, green and blue of "#rrggbb", each from 0 to 1.
constexpr std::array<double, 3> rgb_of(const char* colour) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::array<double, 3> rgb{};
  for (int k = 0; k < 3; ++k) rgb[k] = (16 * digit(colour[1 + 2 * k]) + digit(colour[2 + 2 * k])) / 255.0;
  return rgb;
}

}  // namespace cageproof::reports
