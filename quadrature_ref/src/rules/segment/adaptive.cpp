// SPDX-License-Identifier: MIT
#include "../adaptive.h"
#include "../converted.h"
#include "../kronrod.h"
#include "arm_caster.h"

#include "segment_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// w in [lo, lo + length] on an arm, and the integral over it.
template <Scalar W>
struct Interval {
  int arm;
  W lo, length;
  PartSum<W> part{};
};

// 15 Gauss-Kronrod points; the error is the difference to the embedded rule.
template <Scalar W>
void integrate(const Integrand& integrand, int order, ArmCaster<W>& caster, Interval<W>& interval) {
  const KronrodRule<W>& rule = kronrod_rule<W>();
  Result<W> difference, tensors;
  integrand.reset(interval.part.sums, order);
  integrand.reset(difference, order);
  interval.part.mass = {};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const W w = interval.lo + interval.length * rule.nodes[i];
    const std::array<W, 3> size = caster.sample(interval.arm, w, interval.length, tensors);
    const W off = rule.weights[i] - rule.gauss_weights[i];
    for (int o = 0; o <= order; ++o) {
      for (std::size_t k = 0; k < tensors.of(o).size(); ++k) {
        interval.part.sums.of(o)[k] += rule.weights[i] * tensors.of(o)[k];
        difference.of(o)[k] += off * tensors.of(o)[k];
      }
      interval.part.mass[o] += rule.weights[i] * size[o] * rounding_growth(w, integrand.degree);
    }
  }
  const W missed = unresolved(interval.length);
  for (int o = 0; o <= order; ++o) interval.part.error[o] = norm(difference.of(o)) + missed * interval.part.mass[o];
  interval.part.sums.nodes = rule.nodes.size();
}

template <Scalar W>
AdaptiveOutcome integrate_from(const ArmFrame<Mp200>& exact_frame, const Integrand& integrand,
                               const KernelTask<W>& task, double tolerance, Result<W>& sums) {
  const auto frame = convert<W>(exact_frame);
  ArmCaster<W> caster(frame, integrand, task);
  AdaptiveTotal<W> total(integrand, task.order);
  std::vector<Interval<W>> intervals;
  for (std::size_t k = 0; k < frame.arms.size(); ++k)
    intervals.push_back({.arm = static_cast<int>(k), .lo = 0, .length = frame.arms[k].w_length});
  const auto halve = [](Interval<W>& interval) {
    Interval<W> half = interval;
    half.length = interval.length = half.length / 2;
    half.lo += half.length;
    return half;
  };
  const bool converged = total.refine(
      intervals, W(tolerance), kronrod_rule<W>().nodes.size(),
      [&](Interval<W>& interval) { integrate(integrand, task.order, caster, interval); }, halve);
  sums = total.sums();
  if (is_lost(integrand.formula, exact_frame.height, sums, task.order))
    return {false, std::numeric_limits<double>::infinity()};
  return {converged, static_cast<double>(total.bound())};
}

}  // namespace

template <Scalar R>
void segment::integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  using W = AdaptiveScalar<R>;
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto s = segment_frame(exact.query.corners, exact.query.point);
  if (!s) return fill_not_a_number(result);
  const ConvertedQuery<W> wide(query);
  const KernelTask<W> task = integrand.task(wide.query.parameters, query.order);
  const double tolerance = adaptive_tolerance<R>();
  const auto integrate_at = [&](const Mp200& inward, Result<W>& sums) {
    return integrate_from<W>(arm_frame(*s, inward), integrand, task, tolerance, sums);
  };
  Result<W> sums;
  const AdaptiveOutcome outcome = integrate_off_or_inside(on_segment(*s), query.order, tolerance, integrate_at, sums);
  const auto multiprecision = [&] {
    integrate_multiprecision<R>(integrand, query, digits_beyond_tolerance(tolerance), result);
  };
  set_outcome(integrand, s->exponent, sums, query.order, tolerance, outcome, multiprecision, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void segment::integrate_adaptive<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
