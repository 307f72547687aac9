// SPDX-License-Identifier: MIT
#include "../converted.h"
#include "quad_sum.h"

#include "cageproof/quadrature_ref/quad_rules.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void quad::integrate_multiprecision(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  const double digits = digits_wanted<R>();
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto q = quad_frame(exact.query.corners, exact.query.point);
  if (!q) return fill_not_a_number(result);
  const ClosestPoint c = closest_point(*q);
  if (is_on_quad(*q, c)) {
    fill_not_a_number(result);
    result.converged = true;
    return;
  }
  QuadSum sum(integrand, *q, c, exact.query, digits + 8);
  set_answer(integrand.formula, q->exponent, converge(sum, digits, query.order), query.order, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void quad::integrate_multiprecision<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
