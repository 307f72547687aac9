// SPDX-License-Identifier: MIT
#include "../adaptive.h"
#include "../converted.h"
#include "../finish.h"
#include "inside_quad.h"
#include "quad_cells.h"

#include "quad_rules.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

// Digits the rules are designed for before anything is known of the result.
constexpr double kDesign = 12;

double norm_of_difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return norm(a);
}

struct Part {
  PlannedCell cell;
  Result<double> sums{};
  std::array<double, 3> error{};
  double growth = 1;     ///< how many times as much as elsewhere its nodes' places are off by
  bool split_t = false;  ///< the larger error is along tau
};

class AdaptiveQuad {
 public:
  AdaptiveQuad(const PolarQuadFrame<double>& frame, const Integrand& integrand, const KernelTask<double>& task)
      : integrand_(integrand), order_(task.order), caster_(frame, integrand, task) {}

  /// Refines until the bound meets the tolerance; false when it could not.
  bool refine(const std::vector<PlannedCell>& cells, double tolerance);
  const Result<double>& sums() const { return total_; }
  double bound() const { return bound_; }

 private:
  Result<double> rule(const QuadCell& cell, QuadPoints points) {
    Result<double> sums;
    integrand_.reset(sums, order_);
    caster_.add_cell(cell, points, sums);
    nodes_ += sums.nodes;
    return sums;
  }
  void integrate(Part& part);
  void update();

  const Integrand& integrand_;
  int order_;
  QuadCaster<double> caster_;
  std::vector<Part> parts_;
  Result<double> total_;
  std::array<double, 3> size_{}, error_{};
  double bound_ = 0, rounding_ = 0;
  std::size_t nodes_ = 0;
};

// The finer rule, and its differences to a coarser one along each variable.
void AdaptiveQuad::integrate(Part& part) {
  QuadPoints fine = points_for(part.cell, kDesign);
  // The error estimate compares with a coarser rule, which is unreliable below this many points.
  fine = {std::max(fine.t, 6), std::max(fine.w, 6)};
  const auto coarser = [](int n) { return n - std::max(2, n / 4); };
  part.sums = rule(part.cell.cell, fine);
  // On well shaped quads, terms are a few times as large as their sums.
  part.growth = std::max(1., caster_.cancellation(part.cell.cell) / 4);
  const Result<double> along_t = rule(part.cell.cell, {coarser(fine.t), fine.w});
  const Result<double> along_w = rule(part.cell.cell, {fine.t, coarser(fine.w)});
  double worst_t = 0, worst_w = 0;
  for (int o = 0; o <= order_; ++o) {
    // Not sums of squares, which underflow far away.
    const double error_t = norm_of_difference(part.sums.of(o), along_t.of(o)),
                 error_w = norm_of_difference(part.sums.of(o), along_w.of(o));
    part.error[o] = error_t + error_w;
    // Orders differ in unit: each counts relative to the cell's own tensor.
    const double size = norm(part.sums.of(o));
    if (size > 0) {
      worst_t = std::max(worst_t, error_t / size);
      worst_w = std::max(worst_w, error_w / size);
    }
  }
  part.split_t = worst_t > worst_w;
}

void AdaptiveQuad::update() {
  integrand_.reset(total_, order_);
  bound_ = rounding_ = 0;
  for (int o = 0; o <= order_; ++o) {
    double mass = 0;
    error_[o] = 0;
    for (const Part& part : parts_) {
      for (std::size_t k = 0; k < total_.of(o).size(); ++k) total_.of(o)[k] += part.sums.of(o)[k];
      error_[o] += part.error[o];
      mass += part.growth * norm(part.sums.of(o));
    }
    size_[o] = norm(total_.of(o));
    if (mass == 0) continue;
    // A node's position has an error of a few roundings, its kernel about ten times as much.
    const double rounding = 256 * unit_roundoff<double>() * mass / size_[o], bound = error_[o] / size_[o] + rounding;
    rounding_ = std::max(rounding_, rounding);
    if (!(bound <= bound_)) bound_ = std::isfinite(bound) ? bound : std::numeric_limits<double>::infinity();
  }
  total_.nodes = nodes_;
}

bool AdaptiveQuad::refine(const std::vector<PlannedCell>& cells, double tolerance) {
  for (const PlannedCell& cell : cells) {
    // A plan of so many cells would not end in time; without the cells left out there is no bound.
    if (nodes_ > kAdaptiveNodeLimit * 3 / 4) return update(), bound_ = std::numeric_limits<double>::infinity(), false;
    integrate(parts_.emplace_back(Part{cell}));
  }
  for (;;) {
    update();
    if (bound_ <= tolerance) return true;
    if (!(rounding_ <= tolerance)) return false;
    const std::size_t count = parts_.size();
    for (std::size_t i = 0; i < count; ++i) {
      bool split = false;
      for (int o = 0; o <= order_; ++o)
        split = split || (error_[o] > tolerance * size_[o] / 2 &&
                          parts_[i].error[o] > tolerance / (2 * static_cast<double>(count)) * size_[o]);
      if (!split) continue;
      if (nodes_ > kAdaptiveNodeLimit * 9 / 10) return update(), false;
      Part half{parts_[i].cell};
      QuadCell& first = parts_[i].cell.cell;
      QuadCell& second = half.cell.cell;
      // The halves keep the whole's number of points: that is what makes them better.
      if (parts_[i].split_t) first.t_hi = second.t_lo = (first.t_lo + first.t_hi) / 2;
      else first.w_hi = second.w_lo = (first.w_lo + first.w_hi) / 2;
      integrate(parts_[i]);
      integrate(half);
      parts_.push_back(std::move(half));
    }
    if (parts_.size() == count) return false;  // the rest is rounding
  }
}

// Integrates over a quad as seen from off it.
AdaptiveOutcome integrate_from(const QuadFrame<Mp200>& q, const ClosestPoint& c, const Integrand& integrand,
                               const KernelTask<double>& task, double tolerance, Result<double>& sums) {
  const PolarQuadFrame<Mp200> frame = polar_quad_frame(q, c.u, c.v);
  const PolarQuadFrame<double> rough_frame = convert<double>(frame);
  AdaptiveQuad sum(rough_frame, integrand, task);
  const bool converged = sum.refine(quad_cells(convert<Mp50>(frame), kDesign, 2.5), tolerance);
  sums = sum.sums();
  Mp200 highest = 0;
  for (const Mp200& height : q.heights) highest = std::max<Mp200>(highest, abs(height));
  if (is_lost(integrand.formula, highest, sums, task.order)) return {false, std::numeric_limits<double>::infinity()};
  return {converged, sum.bound()};
}

}  // namespace

template <Scalar R>
void quad::integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  integrand.reset(result, query.order);
  const ConvertedQuery<Mp200> exact(query);
  const auto q = quad_frame(exact.query.corners, exact.query.point);
  if (!q) return fill_not_a_number(result);
  const ClosestPoint c = closest_point(*q);
  // A point so near, but not on the quad, may see its other side, and powers of its distance may leave double's range.
  const bool near = is_on_quad(*q, c), on = near && lies_on_quad(exact.query);
  const OnQuad inside = on ? inside_quad(*q, c) : OnQuad{};
  if (near && (integrand.formula.face_jump.diverges || !inside.yes)) {
    fill_not_a_number(result);
    if (!on) result.stated_digits = 0;
    return;
  }
  const ConvertedQuery<double> rough(query);
  const KernelTask<double> task = integrand.task(rough.query.parameters, query.order);
  const double tolerance = quad::adaptive_tolerance<R>();
  const auto integrate_at = [&](const Mp200& inward, Result<double>& sums) {
    return inward == 0 ? integrate_from(*q, c, integrand, task, tolerance, sums)
                       : integrate_from(seen_from_inside(*q, inside, inward), {inside.u, inside.v, inward * inward},
                                        integrand, task, tolerance, sums);
  };
  Result<double> sums;
  const AdaptiveOutcome outcome = integrate_off_or_inside(inside, query.order, tolerance, integrate_at, sums);
  const auto multiprecision = [&] {
    integrate_multiprecision<R>(integrand, query, digits_beyond_tolerance(tolerance), result);
  };
  set_outcome(integrand, q->exponent, sums, query.order, tolerance, outcome, multiprecision, result);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void quad::integrate_adaptive<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
