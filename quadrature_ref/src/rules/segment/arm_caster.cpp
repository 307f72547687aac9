// SPDX-License-Identifier: MIT
#include "arm_caster.h"

#include "../norms.h"

namespace cageproof::quadrature_ref {

void set_arm_panels(const ArmFrame<Mp200>& frame, const PanelDesign& design, std::vector<ArmPanel>& panels) {
  static thread_local std::vector<double> ends;
  panels.clear();
  for (std::size_t k = 0; k < frame.arms.size(); ++k) {
    set_panel_ends(0, static_cast<double>(frame.arms[k].w_length), frame.singular, design, ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      panels.push_back({static_cast<int>(k), ends[i], ends[i + 1], i + 2 == ends.size()});
  }
}

template <Scalar W>
void ArmCaster<W>::set_node(int arm, const W& w, const W& dw, Node<W>& node) const {
  W sinh_w, cosh_w;
  sinh_cosh(w, sinh_w, cosh_w);
  const Arm<W>& a = frame_.arms[arm];
  const W tau = frame_.distance * sinh_w;
  for (int i = 0; i < 2; ++i) {
    node.x[i] = frame_.base[i] + tau * a.direction[i];
    node.hat[i] = frame_.hat[i] + tau * a.slope[i];
  }
  node.normal = frame_.normal;
  node.height = frame_.height;
  node.log_unit = log_unit_;
  node.weight = frame_.distance * cosh_w * dw;
}

template <Scalar W>
void ArmCaster<W>::add_panel(const ArmPanel& panel, int n, Result<W>& sums) {
  static thread_local std::vector<Node<W>> nodes;
  const GaussNodes<W>& rule = gauss_nodes<W>(n);
  const W whole = length(panel);
  nodes.resize(n);
  for (int i = 0; i < n; ++i)
    set_node(panel.arm, W(panel.lo + whole * rule.nodes[i]), W(whole * rule.weights[i]), nodes[i]);
  kernel_.accumulate(nodes, task_, sums);
  sums.nodes += n;
}

template <Scalar W>
std::array<W, 3> ArmCaster<W>::sample(int arm, const W& w, const W& dw, Result<W>& tensors) {
  Node<W> node;
  set_node(arm, w, dw, node);
  integrand_.reset(tensors, task_.order);
  kernel_.accumulate({&node, 1}, task_, tensors);
  // With the unit's logarithm one larger, the kernel grows by the factor of the logarithm.
  node.log_unit += 1;
  integrand_.reset(shifted_, task_.order);
  kernel_.accumulate({&node, 1}, task_, shifted_);
  std::array<W, 3> size{};
  for (int o = 0; o <= task_.order; ++o) {
    auto& logarithmic = shifted_.of(o);
    for (std::size_t i = 0; i < logarithmic.size(); ++i) logarithmic[i] -= tensors.of(o)[i];
    size[o] = norm(tensors.of(o)) + norm(logarithmic);
  }
  return size;
}

template class ArmCaster<double>;
template class ArmCaster<Mp50>;
template class ArmCaster<Mp100>;
template class ArmCaster<Mp200>;

}  // namespace cageproof::quadrature_ref
