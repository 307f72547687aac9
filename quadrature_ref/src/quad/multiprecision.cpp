// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/quad_rules.h"
#include "quad_sum.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void integrate_quad_multiprecision(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  const double digits = std::same_as<R, Mp100> || std::same_as<R, Mp200> ? 60 : kDigitsPromised;
  result.reset(integrand.formula.components(), 3, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto q = local_quad(exact.query);
  if (!q) return fill_not_a_number(result);
  const ClosestPoint c = closest_point(*q);
  if (is_on_quad(*q, c)) {
    fill_not_a_number(result);
    result.converged = true;
    return;
  }
  QuadSum sum(integrand, *q, c, exact.query, digits + 8);
  const Answer answer = converge(sum, digits, query.order);
  finish(integrand.formula, q->exponent, answer.sums, result);
  result.nodes = answer.sums.nodes;
  for (int order = 0; order <= query.order; ++order)
    result.stated_digits = std::fmin(result.stated_digits, answer.digits[order]);  // ignores NaN
  if (result.stated_digits < 0) result.stated_digits = 0;
  result.converged = result.stated_digits >= kDigitsPromised;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void integrate_quad_multiprecision<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
