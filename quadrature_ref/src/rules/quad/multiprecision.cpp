// SPDX-License-Identifier: MIT
#include "../converted.h"
#include "inside_quad.h"
#include "quad_sum.h"

#include "quad_rules.h"

#include <algorithm>

namespace cageproof::quadrature_ref {
namespace {

// The limit of one attempt, in values in 50 digits: a few seconds for promised digits, more for digits asked for.
constexpr double kBudget = 3e6, kBudgetForMore = 5 * kBudget;

// The digits that a sum falls back to where more cost too much.
constexpr double kFewDigits = 12;

// The natural size of an order's tensor: the longest edge to the power degree - order.
double log10_natural(const Formula& formula, const QuadFrame<Mp200>& q, int order) {
  Mp200 longest = 0;
  for (const auto& edge : q.edges) longest = std::max<Mp200>(longest, length(edge));
  return (formula.degree - order) * log10_magnitude(longest);
}

Answer integral(const Integrand& integrand, const QuadFrame<Mp200>& q, const ClosestPoint& c, const OnQuad& inside,
                const Query<Mp200>& query, double digits) {
  const double budget = digits > kDigitsPromised ? kBudgetForMore : kBudget;
  if (!inside.yes) {
    QuadSum sum(integrand, q, c, query, digits + 8, budget);
    return converge(sum, digits, query.order);
  }
  Inside limit{.moved =
                   [&](const Mp200& inward) {
                     const ClosestPoint below{inside.u, inside.v, inward * inward};
                     return std::make_unique<QuadSum>(integrand, seen_from_inside(q, inside, inward), below, query,
                                                      digits + 8, budget);
                   },
               .clearance = inside.clearance,
               .border = inside.border};
  for (int order = 0; order <= query.order; ++order)
    limit.log10_natural[order] = log10_natural(integrand.formula, q, order);
  return limit_from_inside(limit, digits, query.order);
}

}  // namespace

template <Scalar R>
void quad::integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits,
                                    Result<R>& result) {
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto q = quad_frame(exact.query.corners, exact.query.point);
  if (!q) return fill_not_a_number(result);
  const ClosestPoint c = closest_point(*q);
  const bool on_quad = is_on_quad(*q, c);
  // Diverging weights have no values on the quad. Points that only seem to be on it are nearer than sums resolve.
  const OnQuad inside = on_quad ? inside_quad(*q, c) : OnQuad{};
  if (on_quad && (integrand.formula.face_jump.diverges || !inside.yes || !lies_on_quad(exact.query))) {
    fill_not_a_number(result);
    result.converged = lies_on_quad(exact.query);
    if (!result.converged) result.stated_digits = 0;
    return;
  }
  for (const double asked : {digits, kDigitsPromised, kFewDigits}) {
    if (asked > digits) continue;
    try {
      Answer found;
      // More digits than asked are tried, but may fail.
      const auto as_many = [&](double more) {
        try {
          found = integral(integrand, *q, c, inside, exact.query, more);
        } catch (const TooCostly&) {
          if (more <= asked) throw;
        }
        return found;
      };
      return set_answer(integrand, q->exponent, asked, query.order, as_many, result);
    } catch (const TooCostly&) {
    }
  }
  fill_not_a_number(result);
  result.stated_digits = 0;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void quad::integrate_multiprecision<R>(const Integrand&, const Query<R>&, double, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
