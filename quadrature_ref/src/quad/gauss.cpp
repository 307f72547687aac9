// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/quad_rules.h"
#include "local_quad.h"

#include "cageproof/core/gauss_legendre.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void integrate_quad_gauss(const Integrand& integrand, int n, const Query<R>& query, Result<R>& result) {
  result.reset(integrand.formula.components(), 3, query.order);
  const auto q = local_quad(query);
  if (!q) return fill_not_a_number(result);
  // About the nearest corner, where rounding leaves the height its digits.
  const auto nearest = std::ranges::min_element(q->corners, {}, [](const Vec3<R>& p) { return dot(p, p); });
  const auto corner = nearest - q->corners.begin();
  const R u = corner == 1 || corner == 2 ? 1 : 0, v = corner >= 2 ? 1 : 0;
  const QuadExpansion<R> at = expand(*q, u, v);
  const GaussLegendre<R>& rule = gauss_legendre<R>(n);
  std::vector<Node<R>> row(n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      at.set(R(rule.nodes[i] - u), R(rule.nodes[j] - v), row[j]);
      row[j].weight = rule.weights[i] * rule.weights[j];
    }
    integrand.kernels.at<R>().accumulate(row, query.parameters, query.order, result);
  }
  finish(integrand.formula, q->exponent, Result<R>(result), result);
  result.nodes = static_cast<std::size_t>(n) * n;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void integrate_quad_gauss<R>(const Integrand&, int, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
