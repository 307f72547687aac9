// SPDX-License-Identifier: MIT
// Least squares by a factorisation that finds the rank: kinds and deformers solve such systems once per cage.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <Eigen/Core>

#include <memory>

namespace cageproof {

template <Scalar R>
using Matrix = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;

/// A matrix, factorised (complete orthogonal decomposition): what solve gives is the pseudo-inverse's, the least of the
/// solutions that leave least. Columns that others give to 1e-13 count as dependent, in every scalar alike, so that
/// double and multiprecision solve the same problem. R: double, Mp50, Mp100
template <Scalar R>
class LeastSquares {
 public:
  /// \throws InputError for a matrix that is not finite
  explicit LeastSquares(const Matrix<R>& matrix);
  ~LeastSquares();
  LeastSquares(LeastSquares&&) noexcept;
  LeastSquares& operator=(LeastSquares&&) noexcept;

  int rank() const;
  Matrix<R> solve(const Matrix<R>& right) const;
  /// The pseudo-inverse. Its own error is common to all columns of right sides: where a combination of columns is zero,
  /// the same combination of its products is zero, except for the products' roundings, which grow with its size.
  Matrix<R> inverse() const;

 private:
  struct Factors;
  std::unique_ptr<const Factors> factors_;
};

/// An orthonormal basis of a matrix's null space, one column per vector. Rows that others give to 1e-12 count as
/// dependent. R: double, Mp50
template <Scalar R>
Matrix<R> null_space(const Matrix<R>& matrix);

/// matrix = Q triangle, Q with orthonormal columns.
struct QrFactors {
  Matrix<double> triangle;  ///< upper; as many rows as the matrix has, at most as many as columns
  Matrix<double> turned;    ///< Q^T right, for the whole Q: as many rows as the matrix
};

/// The QR factorisation of a matrix, by blocks. \param right as many rows as the matrix, or nothing
QrFactors qr_factors(const Matrix<double>& matrix, const Matrix<double>& right = {});

/// A description, in double, of the solved system matrix x solution = right. The condition is the ratio of the matrix's
/// singular values. R: double, Mp50
/// \param rank as LeastSquares found it
template <Scalar R>
SolvedSystem describe(std::string name, const Matrix<R>& matrix, int rank, const Matrix<R>& right,
                      const Matrix<R>& solution);

}  // namespace cageproof
