// SPDX-License-Identifier: MIT
#include "../converted.h"
#include "segment_sum.h"

#include "segment_rules.h"

namespace cageproof::quadrature_ref {
namespace {

Inside inside_of(const Integrand& integrand, const SegmentFrame<Mp200>& s, const Query<Mp200>& query,
                 const OnSegment& on) {
  Inside inside{
      .moved =
          [&](const Mp200& inward) { return std::make_unique<SegmentSum>(integrand, arm_frame(s, inward), query); },
      .clearance = on.clearance,
      .border = on.border};
  for (int order = 0; order <= query.order; ++order)
    inside.log10_natural[order] = (integrand.degree - order) * log10_magnitude(s.extent);
  return inside;
}

}  // namespace

template <Scalar R>
void segment::integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits,
                                       Result<R>& result) {
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto s = segment_frame(exact.query.corners, exact.query.point);
  if (!s) return fill_not_a_number(result);
  const auto integral = [&](double asked) {
    if (const OnSegment on = on_segment(*s); on.yes)
      return limit_from_inside(inside_of(integrand, *s, exact.query, on), asked, query.order);
    SegmentSum sum(integrand, arm_frame(*s, Mp200(0)), exact.query);
    return converge(sum, asked, query.order);
  };
  set_answer(integrand, s->exponent, digits, query.order, integral, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void segment::integrate_multiprecision<R>(const Integrand&, const Query<R>&, double, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
