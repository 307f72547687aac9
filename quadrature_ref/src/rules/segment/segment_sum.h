// SPDX-License-Identifier: MIT
// The integral over a segment at any number of digits, cut differently every time it is asked for.
#pragma once

#include "../converging_sum.h"
#include "arm_caster.h"

namespace cageproof::quadrature_ref {

/// Panels of the arms, each with the points and the precision that its share demands.
class SegmentSum final : public ConvergingSum {
 public:
  SegmentSum(const Integrand& integrand, ArmFrame<Mp200> frame, const Query<Mp200>& query);
  /// Alternates between two cuts, so that comparing two sums tests both.
  Result<Mp200> at(double digits) override;

 private:
  struct Cut {
    std::vector<ArmPanel> panels;
    std::vector<std::array<double, 3>> mass;  ///< log10, a panel and order
  };

  Cut cut(const PanelDesign& design);
  /// For each derivative order, log10 of the largest |integrand| times the panel's length, from 3 samples.
  std::array<double, 3> log10_mass(ArmCaster<Mp50>& caster, const ArmPanel& panel) const;
  template <Scalar W>
  void add_panel(const ArmFrame<W>& frame, const ArmPanel& panel, int n, Result<Mp200>& total);
  /// The sum with an absolute error of about 10^log10_error[order].
  Result<Mp200> with_error(const Cut& cut, const std::array<double, 3>& log10_error);
  /// Makes the cuts and finds the norms.
  void scout(double digits);

  ArmFrame<Mp200> exact_frame_;
  ArmFrame<Mp50> frame50_;
  ArmFrame<Mp100> frame100_;
  std::vector<Cut> cuts_;
  int next_ = 0;
};

}  // namespace cageproof::quadrature_ref
