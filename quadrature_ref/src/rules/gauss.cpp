// SPDX-License-Identifier: MIT
#include "gauss.h"

#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

// In quad k (corner k, midpoint to k + 1, centroid, midpoint to k + 2) at (u, v): hat k+1 = u/2 - uv/6, hat k+2 = v/2 -
// uv/6.
template <Scalar R>
void add_three_quads(const LocalTriangle<R>& t, const Kernel<R>& kernel, std::span<const R> parameters, int n,
                     int order, Result<R>& sums) {
  const GaussLegendre<R>& rule = gauss_legendre<R>(n);
  std::vector<Node<R>> row;
  grow_flat(row, n, t.normal, t.height);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < n; ++i) {
      const R& u = rule.nodes[i];
      for (int j = 0; j < n; ++j) {
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
      kernel.accumulate(row, parameters, order, sums);
    }
  sums.nodes += static_cast<std::size_t>(n) * n * 3;
}

template <Scalar R, class Rule>
void integrate(const Integrand& integrand, const Query<R>& query, Result<R>& result, Rule rule) {
  result.reset(integrand.formula.components(), 3, query.order);
  const auto t = local_triangle(query);
  if (!t) return fill_not_a_number(result);
  rule(*t, integrand.kernels.at<R>(), result);
  finish(integrand.formula, t->exponent, Result<R>(result), result);
}

}  // namespace

template <Scalar R>
void integrate_gauss(const Integrand& integrand, int n, const Query<R>& query, Result<R>& result) {
  integrate(integrand, query, result, [&](const LocalTriangle<R>& t, const Kernel<R>& kernel, Result<R>& sums) {
    add_gauss(t, kernel, query.parameters, n, query.order, sums);
  });
}

template <Scalar R>
void integrate_three_quads(const Integrand& integrand, int n, const Query<R>& query, Result<R>& result) {
  integrate(integrand, query, result, [&](const LocalTriangle<R>& t, const Kernel<R>& kernel, Result<R>& sums) {
    add_three_quads(t, kernel, query.parameters, n, query.order, sums);
  });
}

#define CAGEPROOF_INSTANTIATE(R)                                                        \
  template void integrate_gauss<R>(const Integrand&, int, const Query<R>&, Result<R>&); \
  template void integrate_three_quads<R>(const Integrand&, int, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
