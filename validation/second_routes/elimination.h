// SPDX-License-Identifier: MIT
// Square systems by Gaussian elimination with row pivoting, for any number.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace cageproof::second_routes {

/// A dense matrix, row by row.
template <class R>
struct Table {
  std::size_t rows, columns;
  std::vector<R> entries;

  Table(std::size_t r, std::size_t c) : rows(r), columns(c), entries(r * c, R(0)) {}
  R& operator()(std::size_t r, std::size_t c) { return entries[r * columns + c]; }
  const R& operator()(std::size_t r, std::size_t c) const { return entries[r * columns + c]; }
};

/// X with matrix X = right; numbers that are not finite where the matrix is singular.
template <class R>
Table<R> eliminated(Table<R> matrix, Table<R> right) {
  using std::abs;
  const std::size_t n = matrix.rows;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k + 1; r < n; ++r)
      if (abs(matrix(r, k)) > abs(matrix(pivot, k))) pivot = r;
    for (std::size_t c = k; pivot != k && c < n; ++c) std::swap(matrix(k, c), matrix(pivot, c));
    for (std::size_t c = 0; pivot != k && c < right.columns; ++c) std::swap(right(k, c), right(pivot, c));
    for (std::size_t r = k + 1; r < n; ++r) {
      if (matrix(r, k) == 0) continue;
      const R factor = matrix(r, k) / matrix(k, k);
      for (std::size_t c = k + 1; c < n; ++c) matrix(r, c) -= factor * matrix(k, c);
      for (std::size_t c = 0; c < right.columns; ++c) right(r, c) -= factor * right(k, c);
    }
  }
  for (std::size_t k = n; k-- > 0;)
    for (std::size_t c = 0; c < right.columns; ++c) {
      for (std::size_t j = k + 1; j < n; ++j) right(k, c) -= matrix(k, j) * right(j, c);
      right(k, c) /= matrix(k, k);
    }
  return right;
}

}  // namespace cageproof::second_routes
