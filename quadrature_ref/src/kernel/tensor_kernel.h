// SPDX-License-Identifier: MIT
// Kernels whose tensor is a matrix over space, weighted by the basis functions of the element's corners or not, with
// parameters.
#pragma once

#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {

/// The product of a jet and coordinate c of x = xi - eta, whose gradient is -1 there, up to Order.
template <int Order, int Dim, Scalar R>
KernelJet<Dim, R> times_coordinate(const KernelJet<Dim, R>& a, const Node<R>& node, int c) {
  const R& x = node.x[c];
  KernelJet<Dim, R> p;
  p.value = a.value * x;
  if constexpr (Order >= 1) {
    for (int i = 0; i < Dim; ++i) p.gradient[i] = a.gradient[i] * x;
    p.gradient[c] -= a.value;
  }
  if constexpr (Order >= 2)
    for (int i = 0, entry = 0; i < Dim; ++i)
      for (int j = i; j < Dim; ++j, ++entry) {
        p.hessian[entry] = a.hessian[entry] * x;
        if (i == c) p.hessian[entry] -= a.gradient[j];
        if (j == c) p.hessian[entry] -= a.gradient[i];
      }
  return p;
}

/// A kernel from its definition, a class with
///   `Definition(std::span<const R> parameters)`
///   `template <int Order> void jets(const Node<R>&, std::array<KernelJet<Dim, R>, Dim * Dim>&) const`: the matrix, row
///   by row
template <template <int, class> class Definition, int Dim, Scalar R>
class TensorKernel final : public Kernel<R> {
 public:
  void accumulate(std::span<const Node<R>> nodes, const KernelTask<R>& task, Result<R>& sums) const override {
    const Definition<Dim, R> definition(task.parameters);
    if (task.order == 0) accumulate_order<0>(nodes, definition, task.corners, sums);
    else if (task.order == 1) accumulate_order<1>(nodes, definition, task.corners, sums);
    else accumulate_order<2>(nodes, definition, task.corners, sums);
  }

 private:
  static constexpr int kEntries = Dim * Dim;

  template <int Order>
  static void accumulate_order(std::span<const Node<R>> nodes, const Definition<Dim, R>& definition, int corners,
                               Result<R>& sums) {
    std::array<KernelJet<Dim, R>, kEntries> matrix;
    std::array<KernelJet<Dim, R>, kEntries * kMostCorners> totals{};
    const int tensors = corners == 0 ? 1 : corners;
    for (const Node<R>& node : nodes) {
      definition.template jets<Order>(node, matrix);
      for (int k = 0; k < tensors; ++k) {
        const R weight = corners == 0 ? node.weight : R(node.weight * node.hat[k]);
        for (int entry = 0; entry < kEntries; ++entry)
          add_scaled<Order>(matrix[entry], weight, totals[kEntries * k + entry]);
      }
    }
    for (int c = 0; c < kEntries * tensors; ++c) add_component<Order>(totals[c], c, sums);
  }
};

/// The definition's kernel at every precision, in the dimensions it is defined in: `tensor_kernels<KelvinTraction,
/// 3>()`.
template <template <int, class> class Definition, int... Dims>
std::shared_ptr<const KernelSet> tensor_kernels() {
  auto kernels = std::make_shared<KernelSet>();
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(
        kind, [&]<Scalar R>() { (kernels->set<R>(Dims, std::make_unique<TensorKernel<Definition, Dims, R>>()), ...); });
  return kernels;
}

}  // namespace cageproof::quadrature_ref
