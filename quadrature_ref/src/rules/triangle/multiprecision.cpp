// SPDX-License-Identifier: MIT
#include "../converted.h"
#include "triangle_sums.h"

#include "triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

// The natural size of an order's tensor: twice the area times length^(degree - 2 - order).
double log10_natural(const Formula& formula, const TriangleFrame<Mp200>& t, int order) {
  Mp200 longest = 0;
  for (const auto& edge : t.edges) longest = std::max(longest, length(edge));
  return log10_magnitude(t.twice_area) + (formula.degree - 2 - order) * log10_magnitude(longest);
}

Inside inside_of(const Integrand& integrand, const LinedTriangle& t, const Query<Mp200>& query, const OnTriangle& on) {
  Inside inside{
      .moved =
          [&](const Mp200& inward) { return std::make_unique<PolarSum>(integrand, polar_frame(t, inward), query); },
      .clearance = on.clearance,
      .border = on.border};
  for (int order = 0; order <= query.order; ++order)
    inside.log10_natural[order] = log10_natural(integrand.formula, t, order);
  return inside;
}

bool is_far(const TriangleFrame<Mp200>& t) {
  const Vec3<Mp200> to_centroid = (t.corners[0] + t.corners[1] + t.corners[2]) / Mp200(3);
  return std::ranges::all_of(t.edges,
                             [&](const Vec3<Mp200>& e) { return dot(to_centroid, to_centroid) * 4 > dot(e, e) * 9; });
}

Answer integral(const Integrand& integrand, const LinedTriangle& t, const Query<Mp200>& query, double digits) {
  if (is_far(t)) {
    FarSum sum(integrand, t, query);
    return converge(sum, digits, query.order);
  }
  if (const OnTriangle on = on_triangle(t); on.yes)
    return limit_from_inside(inside_of(integrand, t, query, on), digits, query.order);
  PolarSum sum(integrand, polar_frame(t, Mp200(0)), query);
  return converge(sum, digits, query.order);
}

}  // namespace

template <Scalar R>
void triangle::integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits,
                                        Result<R>& result) {
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto t = lined_triangle(exact.query.corners, exact.query.point);
  if (!t) return fill_not_a_number(result);
  set_answer(
      integrand, t->exponent, digits, query.order,
      [&](double asked) { return integral(integrand, *t, exact.query, asked); }, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void triangle::integrate_multiprecision<R>(const Integrand&, const Query<R>&, double, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
