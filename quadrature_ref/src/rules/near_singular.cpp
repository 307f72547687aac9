// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/triangle_rules.h"
#include "inward.h"
#include "polar_cells.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void integrate_near_singular(const Integrand& integrand, int n, const Query<R>& query, Result<R>& result) {
  using W = std::conditional_t<std::same_as<R, float>, double, R>;
  result.reset(integrand.formula.components(), 3, query.order);
  const auto exact_frame = frame_moved_inward(query);
  if (!exact_frame) return fill_not_a_number(result);
  const auto frame = convert<W>(*exact_frame);
  const ConvertedQuery<W> wide(query);
  Result<W> sums;
  sums.reset(integrand.formula.components(), 3, query.order);
  RayCaster<W> caster(frame, integrand, wide.parameters, query.order);
  const double digits = std::min<double>(n, std::numeric_limits<W>::digits10);
  for (const PolarCell& cell : polar_cells(*exact_frame, {.nodes = n, .digits = digits}))
    caster.add_cell(cell, {cell.edge < 0 ? kRingDirections : n, n}, sums);
  finish(integrand.formula, frame.exponent, sums, result);
  result.nodes = sums.nodes;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void integrate_near_singular<R>(const Integrand&, int, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
