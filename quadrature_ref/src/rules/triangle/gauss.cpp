// SPDX-License-Identifier: MIT
#include "gauss.h"

#include "triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

// In quad k (corner k, midpoint to k + 1, centroid, midpoint to k + 2) at (u, v): hat k+1 = u/2 - uv/6, hat k+2 = v/2 -
// uv/6.
template <Scalar R>
void add_three_quads(const TriangleFrame<R>& t, const Kernel<R>& kernel, const KernelTask<R>& task,
                     const GaussNodes<R>& rule, std::vector<Node<R>>& row, Result<R>& sums) {
  const std::size_t n = rule.nodes.size();
  set_flat(row, n, t.normal, t.height, log_of_unit<R>(t.exponent));
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < n; ++i) {
      const R& u = rule.nodes[i];
      for (std::size_t j = 0; j < n; ++j) {
        const R& v = rule.nodes[j];
        const R next = u / 2 - u * v / 6;
        const R last = v / 2 - u * v / 6;
        Node<R>& node = row[j];
        for (int c = 0; c < 3; ++c) node.x[c] = t.corners[k][c] + next * t.edges[k][c] - last * t.edges[(k + 2) % 3][c];
        node.hat[k] = 1 - next - last;
        node.hat[(k + 1) % 3] = next;
        node.hat[(k + 2) % 3] = last;
        node.weight = t.twice_area * (3 - u - v) / 12 * rule.weights[i] * rule.weights[j];
      }
      kernel.accumulate(row, task, sums);
    }
  sums.nodes += n * n * 3;
}

// `add` is a rule on a frame, with memory for a row of its nodes.
template <Scalar R, class Rule>
void integrate(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output, Rule add) {
  static thread_local std::vector<Node<R>> row;
  const GaussNodes<R>& rule = gauss_nodes<R>(n);
  const Kernel<R>& kernel = integrand.kernel<R>();
  const KernelTask<R> task = integrand.task(batch.parameters, batch.order);
  integrate_block<R>(
      integrand, batch, output, [&](const Vec3<R>& point) { return triangle_frame(batch.corners, point); },
      [&](const TriangleFrame<R>& t, Result<R>& sums) { add(t, kernel, task, rule, row, sums); });
}

}  // namespace

namespace triangle {

template <Scalar R>
void integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output) {
  integrate(integrand, n, batch, output, add_gauss<R>);
}

template <Scalar R>
void integrate_three_quads(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output) {
  integrate(integrand, n, batch, output, add_three_quads<R>);
}

#define CAGEPROOF_INSTANTIATE(R)                                                                   \
  template void integrate_gauss<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&); \
  template void integrate_three_quads<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace triangle
}  // namespace cageproof::quadrature_ref
