// SPDX-License-Identifier: MIT
// Kernels whose tensor is a scalar, or a scalar times the hat function of each corner.
#pragma once

#include "cageproof/quadrature_ref/power_jets.h"

namespace cageproof::quadrature_ref {

/// A kernel from its definition, a struct with
///   `static constexpr int corners`: how many hat functions weight the scalar; 0 for the scalar alone
///   `template <Scalar R> static R factor()`: the constant in front
///   `template <int Order, Scalar R> static void jet(const Node<R>&, const R& scale, Jet<R>&)`: scale times the scalar
template <class Definition, Scalar R>
class ScalarKernel final : public Kernel<R> {
 public:
  void accumulate(std::span<const Node<R>> nodes, std::span<const R>, int order, Result<R>& sums) const override {
    if (order == 0) accumulate_order<0>(nodes, sums);
    else if (order == 1) accumulate_order<1>(nodes, sums);
    else accumulate_order<2>(nodes, sums);
  }

 private:
  static constexpr int kTensors = Definition::corners == 0 ? 1 : Definition::corners;

  template <int Order>
  void accumulate_order(std::span<const Node<R>> nodes, Result<R>& sums) const {
    const R factor = Definition::template factor<R>();
    std::array<Jet<R>, kTensors> totals{};
    Jet<R> jet;
    for (const Node<R>& node : nodes) {
      Definition::template jet<Order>(node, R(factor * node.weight), jet);
      if constexpr (Definition::corners == 0) add_jet<Order>(jet, totals[0]);
      else
        for (int k = 0; k < kTensors; ++k) add_scaled<Order>(jet, node.hat[k], totals[k]);
    }
    for (int k = 0; k < kTensors; ++k) {
      sums.value[k] += totals[k].value;
      if constexpr (Order >= 1)
        for (int i = 0; i < 3; ++i) sums.gradient[3 * k + i] += totals[k].gradient[i];
      if constexpr (Order >= 2)
        for (int i = 0, entry = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++entry) sums.hessian[9 * k + 3 * i + j] += totals[k].hessian[entry];
    }
  }

  template <int Order>
  static void add_jet(const Jet<R>& jet, Jet<R>& total) {
    total.value += jet.value;
    if constexpr (Order >= 1)
      for (int i = 0; i < 3; ++i) total.gradient[i] += jet.gradient[i];
    if constexpr (Order >= 2)
      for (int i = 0; i < 6; ++i) total.hessian[i] += jet.hessian[i];
  }

  template <int Order>
  static void add_scaled(const Jet<R>& jet, const R& hat, Jet<R>& total) {
    total.value += hat * jet.value;
    if constexpr (Order >= 1)
      for (int i = 0; i < 3; ++i) total.gradient[i] += hat * jet.gradient[i];
    if constexpr (Order >= 2)
      for (int i = 0; i < 6; ++i) total.hessian[i] += hat * jet.hessian[i];
  }
};

/// The definition's kernel at every precision.
template <class Definition>
std::shared_ptr<const KernelSet> scalar_kernels() {
  auto kernels = std::make_shared<KernelSet>();
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() { kernels->set<R>(std::make_unique<ScalarKernel<Definition, R>>()); });
  return kernels;
}

}  // namespace cageproof::quadrature_ref
