// SPDX-License-Identifier: MIT
// Square systems by Gaussian elimination with row pivoting, for any number.
#pragma once

#include <cmath>
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

template <class R>
Table<R> product(const Table<R>& a, const Table<R>& b) {
  Table<R> found(a.rows, b.columns);
  for (std::size_t r = 0; r < a.rows; ++r)
    for (std::size_t k = 0; k < a.columns; ++k)
      for (std::size_t c = 0; c < b.columns; ++c) found(r, c) += a(r, k) * b(k, c);
  return found;
}

/// Sums of squares |row X - value|^2, by their normal equations.
template <class R>
class NormalEquations {
 public:
  NormalEquations(std::size_t unknowns, std::size_t columns)
      : matrix_(unknowns, unknowns), right_(unknowns, columns), row_(unknowns, R(0)), value_(columns, R(0)) {}

  /// The row and its value that are added next, which start at zero.
  R& row(std::size_t unknown) { return row_[unknown]; }
  R& value(std::size_t column) { return value_[column]; }
  void add(const R& weight = R(1)) {
    for (std::size_t r = 0; r < row_.size(); ++r) {
      if (row_[r] == 0) continue;
      const R factor = weight * row_[r];
      for (std::size_t c = 0; c < row_.size(); ++c) matrix_(r, c) += factor * row_[c];
      for (std::size_t c = 0; c < value_.size(); ++c) right_(r, c) += factor * value_[c];
    }
    row_.assign(row_.size(), R(0));
    value_.assign(value_.size(), R(0));
  }
  /// Where the sum is least. \pre one X makes it so
  Table<R> solution() const { return eliminated(matrix_, right_); }

 private:
  Table<R> matrix_, right_;
  std::vector<R> row_, value_;
};

}  // namespace cageproof::second_routes
