// SPDX-License-Identifier: MIT
// The integral over a triangle at any number of digits.
#pragma once

#include "../converging_sum.h"
#include "polar_cells.h"

namespace cageproof::quadrature_ref {

/// Gauss-Legendre on the collapsed square, for points at least 1.5 longest edges away.
class FarSum final : public ConvergingSum {
 public:
  FarSum(const Integrand& integrand, const TriangleFrame<Mp200>& triangle, const Query<Mp200>& query);
  Result<Mp200> at(double digits) override;

 private:
  template <Scalar W>
  Result<Mp200> at_precision(int n);

  const TriangleFrame<Mp200>& triangle_;
  double log10_rate_;   ///< digits gained by one more point per side
  bool finer_ = false;  ///< see PolarSum
};

/// Polar cells, each with the points and the precision that its share demands.
class PolarSum final : public ConvergingSum {
 public:
  PolarSum(const Integrand& integrand, PolarFrame<Mp200> frame, const Query<Mp200>& query);
  Result<Mp200> at(double digits) override;

 private:
  template <Scalar W>
  void add_cell(const PolarFrame<W>& frame, const PolarCell& cell, CellPoints points, Result<Mp200>& total);
  /// The sum with an absolute error of about 10^log10_error[order].
  Result<Mp200> with_error(const std::array<double, 3>& log10_error);
  /// Finds masses and norms.
  void scout();

  PolarFrame<Mp200> exact_frame_;
  PolarFrame<Mp50> frame50_;
  PolarFrame<Mp100> frame100_;
  std::vector<PolarCell> cells_;
  std::vector<std::array<double, 3>> mass_;  ///< log10, a cell and order
  bool scouted_ = false;
  bool finer_ = false;  ///< every second sum has more points, since rules that share their nodes would agree
};

}  // namespace cageproof::quadrature_ref
