// SPDX-License-Identifier: MIT
#include "../finish.h"
#include "../gauss_nodes.h"
#include "quad_frame.h"

#include "quad_rules.h"

#include <span>

namespace cageproof::quadrature_ref {

namespace {

/// A rule on [0, 1], for both parameters.
template <class R>
struct SideRule {
  std::span<const R> nodes, weights;
};

template <Scalar R>
void integrate_product(const Integrand& integrand, const SideRule<R>& rule, const Batch<R>& batch,
                       const BatchOutput<R>& output) {
  static thread_local std::vector<Node<R>> row;
  const Kernel<R>& kernel = integrand.kernel<R>();
  const KernelTask<R> task = integrand.task(batch.parameters, batch.order);
  const std::size_t n = rule.nodes.size();
  const auto add = [&](const QuadFrame<R>& q, Result<R>& sums) {
    // About the nearest corner, where rounding leaves the height its digits.
    const auto nearest = std::ranges::min_element(q.corners, {}, [](const Vec3<R>& p) { return dot(p, p); });
    const auto corner = nearest - q.corners.begin();
    const R u = corner == 1 || corner == 2 ? 1 : 0, v = corner >= 2 ? 1 : 0;
    const QuadExpansion<R> at = expand(q, u, v);
    row.resize(n);
    for (Node<R>& node : row) node.log_unit = log_of_unit<R>(q.exponent);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        at.set(R(rule.nodes[i] - u), R(rule.nodes[j] - v), row[j]);
        row[j].weight = rule.weights[i] * rule.weights[j];
      }
      kernel.accumulate(row, task, sums);
    }
    sums.nodes = n * n;
  };
  integrate_block<R>(
      integrand, batch, output, [&](const Vec3<R>& point) { return quad_frame(batch.corners, point); }, add);
}

}  // namespace

template <Scalar R>
void quad::integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output) {
  const GaussNodes<R>& rule = gauss_nodes<R>(n);
  integrate_product<R>(integrand, {rule.nodes, rule.weights}, batch, output);
}

template <Scalar R>
void quad::integrate_midpoint(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output) {
  std::vector<R> nodes;
  nodes.reserve(n);
  for (int i = 0; i < n; ++i) nodes.push_back(R(2 * i + 1) / R(2 * n));
  const std::vector<R> weights(n, R(1) / R(n));
  integrate_product<R>(integrand, {nodes, weights}, batch, output);
}

#define CAGEPROOF_INSTANTIATE(R)                                                                         \
  template void quad::integrate_gauss<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&); \
  template void quad::integrate_midpoint<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
