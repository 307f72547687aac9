// SPDX-License-Identifier: MIT
// Kernels whose tensor is a number, weighted by the basis functions of the element's corners or not.
#pragma once

#include "cageproof/quadrature_ref/kernel_jets.h"

namespace cageproof::quadrature_ref {

/// Adds a jet, up to Order.
template <int Order, int Dim, Scalar R>
void add(const KernelJet<Dim, R>& from, KernelJet<Dim, R>& to) {
  to.value += from.value;
  if constexpr (Order >= 1)
    for (std::size_t i = 0; i < from.gradient.size(); ++i) to.gradient[i] += from.gradient[i];
  if constexpr (Order >= 2)
    for (std::size_t i = 0; i < from.hessian.size(); ++i) to.hessian[i] += from.hessian[i];
}

/// Adds scale * from to `to`, up to Order.
template <int Order, int Dim, Scalar R>
void add_scaled(const KernelJet<Dim, R>& from, const R& scale, KernelJet<Dim, R>& to) {
  to.value += scale * from.value;
  if constexpr (Order >= 1)
    for (std::size_t i = 0; i < from.gradient.size(); ++i) to.gradient[i] += scale * from.gradient[i];
  if constexpr (Order >= 2)
    for (std::size_t i = 0; i < from.hessian.size(); ++i) to.hessian[i] += scale * from.hessian[i];
}

/// Adds component c's jet to the sums.
template <int Order, int Dim, Scalar R>
void add_component(const KernelJet<Dim, R>& jet, std::size_t c, Result<R>& sums) {
  sums.value[c] += jet.value;
  if constexpr (Order >= 1)
    for (int i = 0; i < Dim; ++i) sums.gradient[Dim * c + i] += jet.gradient[i];
  if constexpr (Order >= 2)
    for (int i = 0, entry = 0; i < Dim; ++i)
      for (int j = i; j < Dim; ++j, ++entry) sums.hessian[Dim * Dim * c + Dim * i + j] += jet.hessian[entry];
}

/// A kernel from its definition, a struct with
///   `template <int Dim, Scalar R> static R factor()`: the constant in front
///   `template <int Order, int Dim, Scalar R> static void jet(const Node<R>&, const R& scale, KernelJet<Dim, R>&)`:
///   scale times the number
template <class Definition, int Dim, Scalar R>
class ScalarKernel final : public Kernel<R> {
 public:
  void accumulate(std::span<const Node<R>> nodes, const KernelTask<R>& task, Result<R>& sums) const override {
    if (task.order == 0) accumulate_order<0>(nodes, task.corners, sums);
    else if (task.order == 1) accumulate_order<1>(nodes, task.corners, sums);
    else accumulate_order<2>(nodes, task.corners, sums);
  }

 private:
  template <int Order>
  static void accumulate_order(std::span<const Node<R>> nodes, int corners, Result<R>& sums) {
    const R factor = Definition::template factor<Dim, R>();
    std::array<KernelJet<Dim, R>, kMostCorners> totals{};
    KernelJet<Dim, R> jet;
    for (const Node<R>& node : nodes) {
      Definition::template jet<Order>(node, R(factor * node.weight), jet);
      if (corners == 0) add<Order>(jet, totals[0]);
      for (int k = 0; k < corners; ++k) add_scaled<Order>(jet, node.hat[k], totals[k]);
    }
    const int tensors = corners == 0 ? 1 : corners;
    for (int k = 0; k < tensors; ++k) add_component<Order>(totals[k], k, sums);
  }
};

/// A kernel with parameters from its definition, a class with
///   `Definition(std::span<const R> parameters)`
///   `template <int Order, int Dim> void jet(const Node<R>&, const R& scale, KernelJet<Dim, R>&) const`
template <template <class> class Definition, int Dim, Scalar R>
class ParametricKernel final : public Kernel<R> {
 public:
  void accumulate(std::span<const Node<R>> nodes, const KernelTask<R>& task, Result<R>& sums) const override {
    const Definition<R> definition(task.parameters);
    if (task.order == 0) accumulate_order<0>(nodes, definition, task.corners, sums);
    else if (task.order == 1) accumulate_order<1>(nodes, definition, task.corners, sums);
    else accumulate_order<2>(nodes, definition, task.corners, sums);
  }

 private:
  template <int Order>
  static void accumulate_order(std::span<const Node<R>> nodes, const Definition<R>& definition, int corners,
                               Result<R>& sums) {
    std::array<KernelJet<Dim, R>, kMostCorners> totals{};
    KernelJet<Dim, R> jet;
    for (const Node<R>& node : nodes) {
      definition.template jet<Order>(node, node.weight, jet);
      if (corners == 0) add<Order>(jet, totals[0]);
      for (int k = 0; k < corners; ++k) add_scaled<Order>(jet, node.hat[k], totals[k]);
    }
    const int tensors = corners == 0 ? 1 : corners;
    for (int k = 0; k < tensors; ++k) add_component<Order>(totals[k], k, sums);
  }
};

/// The definition's kernel at every precision, in the dimensions it is defined in: `scalar_kernels<SingleLayer, 2,
/// 3>()`.
template <class Definition, int... Dims>
std::shared_ptr<const KernelSet> scalar_kernels() {
  auto kernels = std::make_shared<KernelSet>();
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(
        kind, [&]<Scalar R>() { (kernels->set<R>(Dims, std::make_unique<ScalarKernel<Definition, Dims, R>>()), ...); });
  return kernels;
}

/// The kernels of a definition with parameters: `parametric_kernels<PolyharmonicSingleLayer, 2>()`.
template <template <class> class Definition, int... Dims>
std::shared_ptr<const KernelSet> parametric_kernels() {
  auto kernels = std::make_shared<KernelSet>();
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      (kernels->set<R>(Dims, std::make_unique<ParametricKernel<Definition, Dims, R>>()), ...);
    });
  return kernels;
}

}  // namespace cageproof::quadrature_ref
