// SPDX-License-Identifier: MIT
#include "../converted.h"
#include "quad_sum.h"

#include "cageproof/core/quad_geometry.h"
#include "cageproof/quadrature_ref/quad_rules.h"

#include <algorithm>

namespace cageproof::quadrature_ref {
namespace {

// What one attempt may cost, in values in 50 digits: a few seconds' for those promised; more are asked for knowingly.
constexpr double kBudget = 3e6, kBudgetForMore = 5 * kBudget;

// What a sum falls back to where more digits cost too much.
constexpr double kFewDigits = 12;

// Whether eta, next to the quad, lies on it: decided exactly, for doubles. Others are off it.
bool lies_on_quad(const Query<Mp200>& query) {
  const auto rounded = [](const Vec3<Mp200>& x) { return cageproof::convert<double>(x); };
  const auto is_double = [&](const Vec3<Mp200>& x) { return cageproof::convert<Mp200>(rounded(x)) == x; };
  if (!std::ranges::all_of(query.corners, is_double) || !is_double(query.point)) return false;
  const auto& q = query.corners;
  return on_quad({rounded(q[0]), rounded(q[1]), rounded(q[2]), rounded(q[3])}, rounded(query.point)).has_value();
}

}  // namespace

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
    result.converged = lies_on_quad(exact.query);
    if (!result.converged) result.stated_digits = 0;
    return;
  }
  for (const double asked : {digits, kDigitsPromised, kFewDigits}) {
    if (asked > digits) continue;
    try {
      QuadSum sum(integrand, *q, c, exact.query, asked + 8, asked > kDigitsPromised ? kBudgetForMore : kBudget);
      return set_answer(integrand, q->exponent, converge(sum, asked, query.order), query.order, result);
    } catch (const TooCostly&) {
    }
  }
  fill_not_a_number(result);
  result.stated_digits = 0;
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
