// SPDX-License-Identifier: MIT
// Kernels whose tensor is a 3 x 3 matrix, or one times the hat function of each corner, with parameters.
#pragma once

#include "cageproof/quadrature_ref/power_jets.h"

namespace cageproof::quadrature_ref {

/// The product of two jets, up to Order.
template <int Order, Scalar R>
Jet<R> product(const Jet<R>& a, const Jet<R>& b) {
  Jet<R> p;
  p.value = a.value * b.value;
  if constexpr (Order >= 1)
    for (int i = 0; i < 3; ++i) p.gradient[i] = a.value * b.gradient[i] + b.value * a.gradient[i];
  if constexpr (Order >= 2)
    for (int i = 0, entry = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++entry)
        p.hessian[entry] = a.value * b.hessian[entry] + b.value * a.hessian[entry] +
                           (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]);
  return p;
}

/// Adds scale * from to `to`, up to Order.
template <int Order, Scalar R>
void add_scaled(const Jet<R>& from, const R& scale, Jet<R>& to) {
  to.value += scale * from.value;
  if constexpr (Order >= 1)
    for (int i = 0; i < 3; ++i) to.gradient[i] += scale * from.gradient[i];
  if constexpr (Order >= 2)
    for (int i = 0; i < 6; ++i) to.hessian[i] += scale * from.hessian[i];
}

/// Coordinate i of x = xi - eta.
template <Scalar R>
Jet<R> coordinate_jet(const Node<R>& node, int i) {
  Jet<R> jet;
  jet.value = node.x[i];
  jet.gradient[i] = R(-1);
  return jet;
}

/// x.n, whose value the rule states.
template <Scalar R>
Jet<R> height_jet(const Node<R>& node) {
  Jet<R> jet;
  jet.value = node.height;
  for (int i = 0; i < 3; ++i) jet.gradient[i] = -node.normal[i];
  return jet;
}

/// A kernel from its definition, a class with
///   `static constexpr int corners`: how many hat functions weight the matrix; 0 for the matrix alone
///   `Definition(std::span<const R> parameters)`
///   `template <int Order> void jets(const Node<R>&, std::array<Jet<R>, 9>&) const`: the matrix, row by row
template <template <class> class Definition, Scalar R>
class TensorKernel final : public Kernel<R> {
 public:
  void accumulate(std::span<const Node<R>> nodes, std::span<const R> parameters, int order,
                  Result<R>& sums) const override {
    const Definition<R> definition(parameters);
    if (order == 0) accumulate_order<0>(nodes, definition, sums);
    else if (order == 1) accumulate_order<1>(nodes, definition, sums);
    else accumulate_order<2>(nodes, definition, sums);
  }

 private:
  static constexpr int kCorners = Definition<R>::corners;

  template <int Order>
  void accumulate_order(std::span<const Node<R>> nodes, const Definition<R>& definition, Result<R>& sums) const {
    std::array<Jet<R>, 9> matrix;
    std::vector<Jet<R>> totals(kCorners == 0 ? 9 : 9 * kCorners);
    for (const Node<R>& node : nodes) {
      definition.template jets<Order>(node, matrix);
      for (int k = 0; k < (kCorners == 0 ? 1 : kCorners); ++k) {
        const R weight = kCorners == 0 ? node.weight : R(node.weight * node.hat[k]);
        for (int entry = 0; entry < 9; ++entry) add_scaled<Order>(matrix[entry], weight, totals[9 * k + entry]);
      }
    }
    for (std::size_t c = 0; c < totals.size(); ++c) {
      sums.value[c] += totals[c].value;
      if constexpr (Order >= 1)
        for (int i = 0; i < 3; ++i) sums.gradient[3 * c + i] += totals[c].gradient[i];
      if constexpr (Order >= 2)
        for (int i = 0, entry = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++entry) sums.hessian[9 * c + 3 * i + j] += totals[c].hessian[entry];
    }
  }
};

/// The definition's kernel at every precision.
template <template <class> class Definition>
std::shared_ptr<const KernelSet> tensor_kernels() {
  auto kernels = std::make_shared<KernelSet>();
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() { kernels->set<R>(std::make_unique<TensorKernel<Definition, R>>()); });
  return kernels;
}

}  // namespace cageproof::quadrature_ref
