// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/triangle_rules.h"
#include "converging_sum.h"

namespace cageproof::quadrature_ref {
namespace {

// Orders whose limits agree to fewer digits than that have none; logarithms differ by a tenth.
constexpr double kLimitDigits = 20;

// The natural size of an order's tensor: area times length^(degree - 2 - order).
double log10_natural(const Formula& formula, const LocalTriangle<Mp200>& t, int order) {
  Mp200 longest = 0;
  for (const auto& edge : t.edges) longest = std::max(longest, length(edge));
  return log10_magnitude(t.twice_area) + (formula.degree - 2 - order) * log10_magnitude(longest);
}

// The limit from inside: an order's tensors at two distances agree, are both next to nothing (limit zero), or there is
// none.
Answer limit_from_inside(const Integrand& integrand, const LocalTriangle<Mp200>& t, const Query<Mp200>& query,
                         const Mp200& clearance, double digits) {
  const Mp200 ten = 10;
  PolarSum near_sum(integrand, polar_frame(t, Mp200(clearance * pow(ten, -40))), query);
  PolarSum nearer_sum(integrand, polar_frame(t, Mp200(clearance * pow(ten, -44))), query);
  const Answer near = converge(near_sum, digits, query.order);
  Answer answer = converge(nearer_sum, digits, query.order);
  for (int order = 0; order <= query.order; ++order) {
    auto& tensor = answer.sums.of(order);
    const double tiny = log10_natural(integrand.formula, t, order) - digits - 4;
    if (log10_norm(near.sums.of(order)) < tiny && log10_norm(tensor) < tiny) {
      std::ranges::fill(tensor, Mp200(0));
      answer.digits[order] = digits + 8;
      continue;
    }
    const double limit = agreement(near.sums.of(order), tensor, digits + 8);
    answer.digits[order] = std::min({answer.digits[order], near.digits[order], limit});
    if (limit >= kLimitDigits) continue;
    std::ranges::fill(tensor, std::numeric_limits<Mp200>::quiet_NaN());
    answer.digits[order] = std::numeric_limits<double>::quiet_NaN();
  }
  answer.sums.nodes += near.sums.nodes;
  return answer;
}

bool is_far(const LocalTriangle<Mp200>& t) {
  const Vec3<Mp200> to_centroid = (t.corners[0] + t.corners[1] + t.corners[2]) / Mp200(3);
  return std::ranges::all_of(t.edges,
                             [&](const Vec3<Mp200>& e) { return dot(to_centroid, to_centroid) * 4 > dot(e, e) * 9; });
}

}  // namespace

template <Scalar R>
void integrate_multiprecision(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  const double digits = std::same_as<R, Mp100> || std::same_as<R, Mp200> ? 60 : kDigitsPromised;
  result.reset(integrand.formula.components(), 3, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto t = local_triangle(exact.query);
  if (!t) return fill_not_a_number(result);
  Answer answer;
  if (is_far(*t)) {
    FarSum sum(integrand, *t, exact.query);
    answer = converge(sum, digits, query.order);
  } else if (const OnTriangle on = on_triangle(*t); on.yes) {
    answer = limit_from_inside(integrand, *t, exact.query, on.clearance, digits);
  } else {
    PolarSum sum(integrand, polar_frame(*t, Mp200(0)), exact.query);
    answer = converge(sum, digits, query.order);
  }
  finish(integrand.formula, t->exponent, answer.sums, result);
  result.nodes = answer.sums.nodes;
  for (int order = 0; order <= query.order; ++order)
    result.stated_digits = std::fmin(result.stated_digits, answer.digits[order]);  // ignores NaN
  if (result.stated_digits < 0) result.stated_digits = 0;
  result.converged = result.stated_digits >= kDigitsPromised;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void integrate_multiprecision<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
