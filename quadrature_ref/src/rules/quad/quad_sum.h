// SPDX-License-Identifier: MIT
// The integral over a quad at any number of digits, cut differently every time it is asked for.
#pragma once

#include "../converging_sum.h"
#include "quad_cells.h"

namespace cageproof::quadrature_ref {

/// Thrown where a sum would take more than its budget, or cells that no rule resolves.
struct TooCostly {};

class QuadSum final : public ConvergingSum {
 public:
  /// \param c the quad's point nearest to eta \param digits about those that will be asked for \param budget the cost
  /// of all sums together, in values in 50 digits \throws TooCostly
  QuadSum(const Integrand& integrand, const QuadFrame<Mp200>& q, const ClosestPoint& c, const Query<Mp200>& query,
          double digits, double budget);
  /// Alternates between two centres and cuts, so that comparing two sums tests both. \throws TooCostly
  Result<Mp200> at(double digits) override;

 private:
  struct Cut {
    PolarQuadFrame<Mp200> frame200;
    PolarQuadFrame<Mp50> frame50;
    PolarQuadFrame<Mp100> frame100;
    std::vector<PlannedCell> cells;
    std::vector<std::array<double, 3>> mass;  ///< log10, a cell and order
  };

  Cut cut(PolarQuadFrame<Mp200> frame, double digits, double longest);
  template <Scalar W>
  void add_cell(const PolarQuadFrame<W>& frame, const QuadCell& cell, QuadPoints points, Result<Mp200>& total);
  /// A cell's digits and points.
  struct Rule {
    double digits = 0;
    QuadPoints points{};
  };
  /// Sets the rules for an absolute error of about 10^log10_error[order]. \return their cost \throws TooCostly
  double plan(const Cut& cut, const std::array<double, 3>& log10_error, std::vector<Rule>& rules) const;
  /// The sum with that error. \throws TooCostly before anything is summed
  Result<Mp200> with_error(const Cut& cut, const std::array<double, 3>& log10_error);

  double budget_;
  std::array<Cut, 2> cuts_;
  int next_ = 0;
};

}  // namespace cageproof::quadrature_ref
