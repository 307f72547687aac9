// SPDX-License-Identifier: MIT
// Rows of coordinates times data, each row by itself, so that it makes no difference in which blocks points come.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace cageproof::deformation {

/// Adds sum_i row[i] times data[c][i] to each of D sums. \param data D columns, each as long as the row
template <int D>
void add_row_products(std::span<const double> row, const std::array<const double*, D>& data, double* sums) {
  // As many terms at once as keep two vectors of the processor busy.
  constexpr std::size_t lanes = 4;
  std::array<std::array<double, lanes>, D> partial{};
  const std::size_t whole = row.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (int c = 0; c < D; ++c)
      for (std::size_t k = 0; k < lanes; ++k) partial[c][k] += row[i + k] * data[c][i + k];
  for (int c = 0; c < D; ++c) {
    double rest = 0;
    for (std::size_t i = whole; i < row.size(); ++i) rest += row[i] * data[c][i];
    sums[c] += (partial[c][0] + partial[c][1]) + (partial[c][2] + partial[c][3]) + rest;
  }
}

}  // namespace cageproof::deformation
