// SPDX-License-Identifier: MIT
// Least squares whose unknowns are not negative, by trying every set of those that are not zero.
#pragma once

#include "regularised_routes.h"

namespace cageproof::deformation::test {

/// The s >= 0 of least s^T matrix s - 2 s^T right: of normal equations, whose energies have a constant in common.
/// \param right a column, of a dozen rows or so
inline Mp least_not_negative(const Mp& matrix, const Mp& right) {
  const int m = static_cast<int>(right.rows());
  Mp best = Mp::Zero(m, 1);
  Mp50 least = 0;
  for (unsigned set = 1; set < 1U << m; ++set) {
    std::vector<int> columns;
    columns.reserve(m);
    for (int k = 0; k < m; ++k)
      if ((set >> k & 1U) != 0) columns.push_back(k);
    const Mp part = matrix(columns, columns), data = right(columns, Eigen::all);
    const Mp solution = Eigen::PartialPivLU<Mp>(part).solve(data);
    const Mp50 lowered = -data.cwiseProduct(solution).sum();
    if (solution.minCoeff() < 0 || lowered >= least) continue;
    least = lowered;
    best.setZero();
    for (std::size_t k = 0; k < columns.size(); ++k) best(columns[k], 0) = solution(static_cast<int>(k), 0);
  }
  return best;
}

}  // namespace cageproof::deformation::test
