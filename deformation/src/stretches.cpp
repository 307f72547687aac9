// SPDX-License-Identifier: MIT
#include "stretches.h"

#include "layers/solver.h"
#include "nonnegative.h"

#include <fmt/format.h>

#include <string>

namespace cageproof::deformation {
namespace {

template <Scalar R>
Matrix<R> nonnegative_stretches(const Matrix<R>& matrix, const Matrix<R>& right, const Matrix<R>& start,
                                const std::string& name, DeformationReport& report) {
  // Where no stretch of all is negative, these are the least.
  if (const LeastSquares<R> factors(matrix); factors.rank() == matrix.cols()) {
    const Matrix<R> step = factors.solve(right);
    if (Matrix<R> sigma = start + step; sigma.minCoeff() > 0) {
      report.systems.push_back(
          describe<R>(fmt::format("{}, none negative", name), matrix, factors.rank(), right, step));
      report.figures.emplace_back("zero sigma", 0);
      return sigma;
    }
  }
  const NonNegativeSolution<R> found = nonnegative_least_squares<R>(matrix, Matrix<R>(right + matrix * start));
  report.systems.push_back(describe<R>(fmt::format("{}, none negative", name), matrix, found.rank,
                                       Matrix<R>(right + matrix * start), found.values));
  if (found.rank < matrix.cols())
    report.warnings.push_back(fmt::format("{}: rank {} of {}, so that others that are not negative leave as little",
                                          name, found.rank, matrix.cols()));
  if (!found.is_optimal)
    report.warnings.push_back(
        fmt::format("{} are not the least that are not negative: the conditions for these are violated by {:.2g}", name,
                    found.violation));
  report.figures.emplace_back("zero sigma", found.zeros);
  return found.values;
}

template <Scalar R>
Matrix<R> any_stretches(const Matrix<R>& matrix, const Matrix<R>& right, const Matrix<R>& start,
                        const std::string& name, DeformationReport& report) {
  Matrix<R> sigma = start + least_squares<R>(matrix, right, name, report.systems);
  Eigen::Index negative = 0;
  for (const R& s : sigma.reshaped()) negative += s < 0 ? 1 : 0;
  report.figures.emplace_back("negative sigma", static_cast<double>(negative));
  if (negative > 0)
    report.warnings.push_back(
        fmt::format("{} of {} sigma are negative: the image is turned inside out there", negative, sigma.rows()));
  return sigma;
}

}  // namespace

template <Scalar R>
Matrix<R> least_stretched(const Matrix<R>& of_normals, const Matrix<R>& fixed, const Matrix<R>& units,
                          const Matrix<R>& start, bool nonnegative, DeformationReport& report) {
  // A coordinate of the image below the other.
  const Eigen::Index rows = of_normals.rows(), count = units.rows(), d = units.cols();
  Matrix<R> matrix(d * rows, count), right(d * rows, 1);
  for (Eigen::Index c = 0; c < d; ++c) {
    matrix.middleRows(c * rows, rows) = of_normals * units.col(c).asDiagonal();
    right.middleRows(c * rows, rows) = -fixed.col(c);
  }
  const std::string name = "stretches of least energy";
  const Matrix<R> sigma = nonnegative ? nonnegative_stretches<R>(matrix, right, start, name, report)
                                      : any_stretches<R>(matrix, right, start, name, report);
  report.figures.emplace_back("least sigma", static_cast<double>(R(sigma.minCoeff())));
  report.figures.emplace_back("largest sigma", static_cast<double>(R(sigma.maxCoeff())));
  return sigma.reshaped().asDiagonal() * units;
}

template Matrix<double> least_stretched<double>(const Matrix<double>&, const Matrix<double>&, const Matrix<double>&,
                                                const Matrix<double>&, bool, DeformationReport&);
template Matrix<Mp50> least_stretched<Mp50>(const Matrix<Mp50>&, const Matrix<Mp50>&, const Matrix<Mp50>&,
                                            const Matrix<Mp50>&, bool, DeformationReport&);

}  // namespace cageproof::deformation
