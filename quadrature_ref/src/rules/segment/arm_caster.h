// SPDX-License-Identifier: MIT
// Rules on the arms of a segment.
#pragma once

#include "../finish.h"
#include "../gauss_nodes.h"
#include "arm_frame.h"

namespace cageproof::quadrature_ref {

/// An interval of w on an arm.
struct ArmPanel {
  int arm = 0;
  double lo = 0, hi = 0;
  bool last = false;  ///< hi stands for the arm's w_length, at full precision
};

/// Sets `panels` to those of a frame, designed as `design` says.
void set_arm_panels(const ArmFrame<Mp200>& frame, const PanelDesign& design, std::vector<ArmPanel>& panels);

/// Feeds a kernel with the points of arms.
template <Scalar W>
class ArmCaster {
 public:
  /// Keeps references to all it is given.
  ArmCaster(const ArmFrame<W>& frame, const Integrand& integrand, const KernelTask<W>& task)
      : frame_(frame),
        integrand_(integrand),
        kernel_(integrand.kernel<W>()),
        task_(task),
        log_unit_(log_of_unit<W>(frame.exponent)) {}

  /// Adds the n-point Gauss-Legendre rule on a panel.
  void add_panel(const ArmPanel& panel, int n, Result<W>& sums);
  /// The panel's length in w.
  W length(const ArmPanel& panel) const {
    return (panel.last ? frame_.arms[panel.arm].w_length : W(panel.hi)) - W(panel.lo);
  }
  /// Sets `tensors` to those of one point of an arm, of weight dw.
  /// \return an order: the size that rounding is relative to: the tensor's, and that of the logarithm's own in it,
  /// which is no smaller where the logarithm is close to zero
  std::array<W, 3> sample(int arm, const W& w, const W& dw, Result<W>& tensors);

 private:
  void set_node(int arm, const W& w, const W& dw, Node<W>& node) const;

  const ArmFrame<W>& frame_;
  const Integrand& integrand_;
  const Kernel<W>& kernel_;
  KernelTask<W> task_;
  W log_unit_;
  Result<W> shifted_;
};

}  // namespace cageproof::quadrature_ref
