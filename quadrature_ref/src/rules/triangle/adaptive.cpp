// SPDX-License-Identifier: MIT
#include "../adaptive.h"
#include "../converted.h"
#include "../kronrod.h"
#include "moved_inward.h"
#include "polar_cells.h"

#include "triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// t in [t_lo, t_lo + t_length] of an edge, w from the disc to the edge in fractions [lower, upper]; edge -1: a ring of
/// the disc, w in fractions of its end. With the integral over it.
template <Scalar W>
struct Rectangle {
  int edge;
  W t_lo, t_length, lower, upper;
  PartSum<W> part{};
  bool split_t = false;  ///< the larger error is along t
};

template <Scalar W>
class AdaptiveSum {
 public:
  /// \param disc w at the end of the disc around c
  AdaptiveSum(const PolarFrame<W>& frame, double disc, const Integrand& integrand, const KernelTask<W>& task)
      : frame_(frame),
        disc_(disc),
        integrand_(integrand),
        order_(task.order),
        caster_(frame, integrand, task),
        total_(integrand, order_) {
    if (integrand.formula.gradient_cancels_above) cancelled_ = 1 + frame.distance / longest_edge(frame);
  }

  /// Refines until the bound meets the tolerance; false when it could not.
  bool refine(const W& tolerance);
  const AdaptiveTotal<W>& total() const { return total_; }

 private:
  static W longest_edge(const PolarFrame<W>& frame) {
    W longest = 0;
    for (const PolarEdge<W>& edge : frame.edges) longest = std::max<W>(longest, 2 * edge.a / edge.relative_height);
    return longest;
  }
  void reset(Result<W>& sums) const { integrand_.reset(sums, order_); }
  void integrate(Rectangle<W>& rectangle);
  void add_ray(Rectangle<W>& rectangle, const W& w_from, const W& w_to, const W& weight, const W& difference,
               const W& growth);

  const PolarFrame<W>& frame_;
  W disc_;
  const Integrand& integrand_;
  int order_;
  // How many times as large as the gradient its terms are, far above the triangle.
  W cancelled_ = 1;
  RayCaster<W> caster_;
  Result<W> ray_, difference_t_, difference_w_;
  std::vector<RadialPoint<W>> points_ = std::vector<RadialPoint<W>>(15), differences_ = points_;
  AdaptiveTotal<W> total_;
};

// Integrates along the ray aimed at; `weight` is the ray's in the finer rule across rays, `difference` to the coarser
// one. `growth`: of the rounding of the ray's direction.
template <Scalar W>
void AdaptiveSum<W>::add_ray(Rectangle<W>& rectangle, const W& w_from, const W& w_to, const W& weight,
                             const W& difference, const W& growth) {
  const KronrodRule<W>& rule = kronrod_rule<W>();
  const W lo = w_from + rectangle.lower * (w_to - w_from);
  const W length = (rectangle.upper - rectangle.lower) * (w_to - w_from);
  W sinh_w, cosh_w;
  for (int j = 0; j < 15; ++j) {
    sinh_cosh(W(lo + length * rule.nodes[j]), sinh_w, cosh_w);
    points_[j].tau = differences_[j].tau = frame_.distance * sinh_w;
    const W element = points_[j].tau * frame_.distance * cosh_w * length;
    points_[j].weight = element * rule.weights[j];
    differences_[j].weight = element * (rule.weights[j] - rule.gauss_weights[j]);
  }
  reset(ray_);
  caster_.cast(points_, W(1), ray_);
  caster_.cast(differences_, weight, difference_w_);
  for (int o = 0; o <= order_; ++o) {
    for (std::size_t k = 0; k < ray_.of(o).size(); ++k) {
      rectangle.part.sums.of(o)[k] += weight * ray_.of(o)[k];
      difference_t_.of(o)[k] += difference * ray_.of(o)[k];
    }
    rectangle.part.mass[o] +=
        weight * norm(ray_.of(o)) * growth * rounding_growth(w_to, integrand_.degree) * (o > 0 ? cancelled_ : W(1));
  }
  rectangle.part.sums.nodes += 30;
}

template <Scalar W>
void AdaptiveSum<W>::integrate(Rectangle<W>& rectangle) {
  for (Result<W>* r : {&rectangle.part.sums, &difference_t_, &difference_w_}) reset(*r);
  rectangle.part.error = rectangle.part.mass = {};
  W longest = 0;  // of the rays' parts, in w
  if (rectangle.edge < 0) {
    const W step = 2 * pi<W>() / kRingDirections;
    for (int i = 0; i < kRingDirections; ++i) {
      caster_.aim_around(W(step * i));
      longest = (rectangle.upper - rectangle.lower) * disc_;
      add_ray(rectangle, W(0), disc_, step, i % 2 == 0 ? W(-step) : step,
              W(1));  // the coarser rule: every other direction
    }
  } else {
    const KronrodRule<W>& rule = kronrod_rule<W>();
    W cosh_v;
    for (int i = 0; i < 15; ++i) {
      const W t = rectangle.t_lo + rectangle.t_length * rule.nodes[i];
      const W w_edge = caster_.aim(frame_.edges[rectangle.edge], t, cosh_v);
      const W angle = rectangle.t_length / cosh_v;
      longest = std::max<W>(longest, (rectangle.upper - rectangle.lower) * (w_edge - disc_));
      add_ray(rectangle, disc_, w_edge, W(angle * rule.weights[i]),
              W(angle * (rule.weights[i] - rule.gauss_weights[i])),
              rounding_growth(W(frame_.edges[rectangle.edge].v0 + t), integrand_.degree));
    }
  }
  W error_t = 0, error_w = 0;
  const W missed_t = unresolved(rectangle.t_length), missed_w = unresolved(longest);
  for (int o = 0; o <= order_; ++o) {
    const W along_t = norm(difference_t_.of(o)) + missed_t * rectangle.part.mass[o];
    const W along_w = norm(difference_w_.of(o)) + missed_w * rectangle.part.mass[o];
    rectangle.part.error[o] = along_t + along_w;
    // Orders differ in unit: each counts relative to the rectangle's own mass.
    if (rectangle.part.mass[o] > 0) {
      error_t = std::max<W>(error_t, along_t / rectangle.part.mass[o]);
      error_w = std::max<W>(error_w, along_w / rectangle.part.mass[o]);
    }
  }
  rectangle.split_t = rectangle.edge >= 0 && error_t > error_w;
}

template <Scalar W>
bool AdaptiveSum<W>::refine(const W& tolerance) {
  std::vector<Rectangle<W>> rectangles;
  if (disc_ > 0) rectangles.push_back({.edge = -1, .t_lo = 0, .t_length = 0, .lower = 0, .upper = 1});
  for (std::size_t k = 0; k < frame_.edges.size(); ++k)
    rectangles.push_back(
        {.edge = static_cast<int>(k), .t_lo = 0, .t_length = frame_.edges[k].v_length, .lower = 0, .upper = 1});
  const auto halve = [](Rectangle<W>& rectangle) {
    Rectangle<W> half = rectangle;
    if (half.split_t) {
      half.t_length = rectangle.t_length = half.t_length / 2;
      half.t_lo += half.t_length;
    } else {
      half.lower = rectangle.upper = (half.lower + half.upper) / 2;
    }
    return half;
  };
  return total_.refine(
      rectangles, tolerance, 450, [&](Rectangle<W>& rectangle) { integrate(rectangle); }, halve);
}

// Integrates from one frame, in scalar W.
template <Scalar W>
AdaptiveOutcome integrate_from(const PolarFrame<Mp200>& exact_frame, const Integrand& integrand,
                               const KernelTask<W>& task, double tolerance, Result<W>& sums) {
  const auto frame = convert<W>(exact_frame);
  AdaptiveSum<W> sum(frame, disc_end(exact_frame), integrand, task);
  const bool converged = sum.refine(W(tolerance));
  sums = sum.total().sums();
  if (is_lost(integrand.formula, exact_frame.height, sums, task.order))
    return {false, std::numeric_limits<double>::infinity()};
  return {converged, static_cast<double>(sum.total().bound())};
}

}  // namespace

template <Scalar R>
void triangle::integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  using W = AdaptiveScalar<R>;
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto t = lined_triangle(exact.query.corners, exact.query.point);
  if (!t) return fill_not_a_number(result);
  const ConvertedQuery<W> wide(query);
  const KernelTask<W> task = integrand.task(wide.query.parameters, query.order);
  const double tolerance = adaptive_tolerance<R>();
  const auto integrate_at = [&](const Mp200& inward, Result<W>& sums) {
    return integrate_from<W>(polar_frame(*t, inward), integrand, task, tolerance, sums);
  };
  Result<W> sums;
  const AdaptiveOutcome outcome = integrate_off_or_inside(on_triangle(*t), query.order, tolerance, integrate_at, sums);
  const auto multiprecision = [&] {
    integrate_multiprecision<R>(integrand, query, digits_beyond_tolerance(tolerance), result);
  };
  set_outcome(integrand, t->exponent, sums, query.order, tolerance, outcome, multiprecision, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void triangle::integrate_adaptive<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
