// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/triangle_rules.h"
#include "inward.h"
#include "polar_cells.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace cageproof::quadrature_ref {
namespace {

/// The 15-point Gauss-Kronrod rule on [0, 1] with the embedded 7-point Gauss rule's weights (zero at the other nodes).
template <Scalar W>
struct KronrodRule {
  std::array<W, 15> nodes, weights, gauss_weights;
};

template <Scalar W>
const KronrodRule<W>& kronrod_rule() {
  using Kronrod = boost::math::quadrature::gauss_kronrod<W, 15>;
  using Gauss = boost::math::quadrature::gauss<W, 7>;
  static const KronrodRule<W> rule = [] {
    KronrodRule<W> r;
    for (int k = 0; k < 8; ++k)  // abscissas from the centre outwards; the even ones are Gauss nodes
      for (const int side : {-1, 1}) {
        const int i = 7 + side * k;
        r.nodes[i] = (1 + side * W(Kronrod::abscissa()[k])) / 2;
        r.weights[i] = W(Kronrod::weights()[k]) / 2;
        r.gauss_weights[i] = k % 2 == 0 ? W(W(Gauss::weights()[k / 2]) / 2) : W(0);
      }
    return r;
  }();
  return rule;
}

template <Scalar W>
W norm(const std::vector<W>& tensor) {
  using std::sqrt;
  W square = 0;
  for (const W& entry : tensor) square += entry * entry;
  return sqrt(square);
}

// Infinite where nothing can be said.
template <Scalar W>
double relative_difference(const std::vector<W>& a, const std::vector<W>& b) {
  std::vector<W> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  const double ratio = static_cast<double>(W(norm(difference) / norm(b)));
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

/// t in [t_lo, t_lo + t_length] of an edge, w from the disc to the edge in fractions [lower, upper]; edge -1: a ring of
/// the disc, w in fractions of its end. And what was integrated over it.
template <Scalar W>
struct Rectangle {
  int edge;
  W t_lo, t_length, lower, upper;
  Result<W> sums{};
  std::array<W, 3> error{}, mass{};
  bool split_t = false;  ///< the larger error is along t
};

template <Scalar W>
class AdaptiveSum {
 public:
  /// \param disc w at the end of the disc around c
  AdaptiveSum(const PolarFrame<W>& frame, double disc, const Integrand& integrand, std::span<const W> parameters,
              int order)
      : frame_(frame),
        disc_(disc),
        components_(integrand.formula.components()),
        order_(order),
        caster_(frame, integrand, parameters, order) {}

  /// Refines until the bound meets the tolerance; false when it could not.
  bool refine(const W& tolerance);
  const Result<W>& sums() const { return total_; }
  /// Bound of the relative error over the orders.
  W bound() const { return bound_; }

 private:
  void reset(Result<W>& sums) const { sums.reset(components_, 3, order_); }
  void integrate(Rectangle<W>& rectangle);
  void add_ray(Rectangle<W>& rectangle, const W& w_from, const W& w_to, const W& weight, const W& difference);
  void update();
  bool needs_split(const Rectangle<W>& rectangle, const W& tolerance) const;
  bool hopeless(const W& tolerance) const;

  const PolarFrame<W>& frame_;
  W disc_;
  int components_;
  int order_;
  RayCaster<W> caster_;
  std::vector<Rectangle<W>> rectangles_;
  Result<W> ray_, difference_t_, difference_w_;
  std::vector<RadialPoint<W>> points_ = std::vector<RadialPoint<W>>(15), differences_ = points_;
  Result<W> total_;
  std::array<W, 3> size_{}, error_{}, rounding_{};
  W bound_ = 0;
  std::size_t nodes_ = 0;
};

// Integrates along the ray aimed at; `weight` is the ray's in the finer rule across rays, `difference` to the coarser
// one.
template <Scalar W>
void AdaptiveSum<W>::add_ray(Rectangle<W>& rectangle, const W& w_from, const W& w_to, const W& weight,
                             const W& difference) {
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
      rectangle.sums.of(o)[k] += weight * ray_.of(o)[k];
      difference_t_.of(o)[k] += difference * ray_.of(o)[k];
    }
    rectangle.mass[o] += weight * norm(ray_.of(o));
  }
  nodes_ += 30;
}

template <Scalar W>
void AdaptiveSum<W>::integrate(Rectangle<W>& rectangle) {
  for (Result<W>* r : {&rectangle.sums, &difference_t_, &difference_w_}) reset(*r);
  rectangle.error = rectangle.mass = {};
  if (rectangle.edge < 0) {
    const W step = 2 * pi<W>() / kRingDirections;
    for (int i = 0; i < kRingDirections; ++i) {
      caster_.aim_around(W(step * i));
      add_ray(rectangle, W(0), disc_, step, i % 2 == 0 ? W(-step) : step);  // the coarser rule: every other direction
    }
  } else {
    const KronrodRule<W>& rule = kronrod_rule<W>();
    W cosh_v;
    for (int i = 0; i < 15; ++i) {
      const W t = rectangle.t_lo + rectangle.t_length * rule.nodes[i];
      const W w_edge = caster_.aim(frame_.edges[rectangle.edge], t, cosh_v);
      const W angle = rectangle.t_length / cosh_v;
      add_ray(rectangle, disc_, w_edge, W(angle * rule.weights[i]),
              W(angle * (rule.weights[i] - rule.gauss_weights[i])));
    }
  }
  W error_t = 0, error_w = 0;
  for (int o = 0; o <= order_; ++o) {
    const W along_t = norm(difference_t_.of(o)), along_w = norm(difference_w_.of(o));
    rectangle.error[o] = along_t + along_w;
    // Orders differ in unit: each counts relative to the rectangle's own mass.
    if (rectangle.mass[o] > 0) {
      error_t = std::max<W>(error_t, along_t / rectangle.mass[o]);
      error_w = std::max<W>(error_w, along_w / rectangle.mass[o]);
    }
  }
  rectangle.split_t = rectangle.edge >= 0 && error_t > error_w;
}

template <Scalar W>
void AdaptiveSum<W>::update() {
  using std::isfinite;
  total_.reset(components_, 3, order_);
  bound_ = 0;
  for (int o = 0; o <= order_; ++o) {
    W mass = 0;
    error_[o] = 0;
    for (const Rectangle<W>& rectangle : rectangles_) {
      for (std::size_t k = 0; k < total_.of(o).size(); ++k) total_.of(o)[k] += rectangle.sums.of(o)[k];
      error_[o] += rectangle.error[o];
      mass += rectangle.mass[o];
    }
    size_[o] = norm(total_.of(o));
    // A node's position is off by a few roundings, its kernel by about ten times as many.
    rounding_[o] = 64 * unit_roundoff<W>() * mass;
    if (mass == 0) continue;
    const W bound = (error_[o] + rounding_[o]) / size_[o];
    if (!(bound <= bound_)) bound_ = isfinite(bound) ? bound : std::numeric_limits<W>::infinity();
  }
  total_.nodes = nodes_;
}

template <Scalar W>
bool AdaptiveSum<W>::needs_split(const Rectangle<W>& rectangle, const W& tolerance) const {
  const W share = tolerance / (2 * static_cast<double>(rectangles_.size()));
  for (int o = 0; o <= order_; ++o)
    if (error_[o] > tolerance * size_[o] / 2 && rectangle.error[o] > share * size_[o]) return true;
  return false;
}

// Bisection leaves the rounding as it is: true when it alone breaks the tolerance, whatever the tensors turn out to be.
template <Scalar W>
bool AdaptiveSum<W>::hopeless(const W& tolerance) const {
  for (int o = 0; o <= order_; ++o)
    if (!(rounding_[o] <= tolerance * (size_[o] + error_[o]))) return true;
  return false;
}

template <Scalar W>
bool AdaptiveSum<W>::refine(const W& tolerance) {
  if (disc_ > 0) rectangles_.push_back({.edge = -1, .t_lo = 0, .t_length = 0, .lower = 0, .upper = 1});
  for (std::size_t k = 0; k < frame_.edges.size(); ++k)
    rectangles_.push_back(
        {.edge = static_cast<int>(k), .t_lo = 0, .t_length = frame_.edges[k].v_length, .lower = 0, .upper = 1});
  for (Rectangle<W>& rectangle : rectangles_) integrate(rectangle);
  for (;;) {
    update();
    if (bound_ <= tolerance) return true;
    if (hopeless(tolerance)) return false;
    const std::size_t count = rectangles_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!needs_split(rectangles_[i], tolerance)) continue;
      if (nodes_ + 2 * 450 > kAdaptiveNodeLimit) return update(), false;
      Rectangle<W> half = rectangles_[i];
      if (half.split_t) {
        half.t_length = rectangles_[i].t_length = half.t_length / 2;
        half.t_lo += half.t_length;
      } else {
        half.lower = rectangles_[i].upper = (half.lower + half.upper) / 2;
      }
      integrate(rectangles_[i]);
      integrate(half);
      rectangles_.push_back(std::move(half));
    }
    if (rectangles_.size() == count) return false;  // what is left is rounding
  }
}

struct Outcome {
  bool converged;
  double bound;
};

// Integrates from one frame, in scalar W.
template <Scalar W>
Outcome integrate_from(const PolarFrame<Mp200>& exact_frame, const Integrand& integrand, std::span<const W> parameters,
                       int order, double tolerance, Result<W>& sums) {
  const auto frame = convert<W>(exact_frame);
  AdaptiveSum<W> sum(frame, disc_end(exact_frame), integrand, parameters, order);
  const bool converged = sum.refine(W(tolerance));
  sums = sum.sums();
  return {converged, static_cast<double>(sum.bound())};
}

}  // namespace

template <Scalar R>
void integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result) {
  using W = std::conditional_t<std::same_as<R, float>, double, std::conditional_t<is_multiprecision<R>, Mp50, R>>;
  result.reset(integrand.formula.components(), 3, query.order);
  const auto t = local_triangle(ConvertedQuery<Mp200>(query).query);
  if (!t) return fill_not_a_number(result);
  const ConvertedQuery<W> wide(query);
  const double tolerance = adaptive_tolerance<R>();
  const auto integrate_at = [&](const Mp200& inward, Result<W>& sums) {
    return integrate_from<W>(polar_frame(*t, inward), integrand, wide.parameters, query.order, tolerance, sums);
  };
  const OnTriangle on = on_triangle(*t);
  Result<W> sums;
  Outcome outcome = integrate_at(on.yes ? Mp200(on.clearance * kInward) : Mp200(0), sums);
  if (on.yes) {
    Result<W> farther;
    outcome.converged = integrate_at(Mp200(on.clearance * kInward * 100), farther).converged && outcome.converged;
    for (int o = 0; o <= query.order; ++o)
      outcome.bound = std::max(outcome.bound, relative_difference(farther.of(o), sums.of(o)));
    outcome.converged = outcome.converged && outcome.bound <= tolerance;
    sums.nodes += farther.nodes;
  }
  finish(integrand.formula, t->exponent, sums, result);
  result.nodes = sums.nodes;
  result.converged = outcome.converged;
  // Rounding the result to R is part of the error.
  const double bound = outcome.bound + static_cast<double>(unit_roundoff<R>());
  result.stated_digits = bound < 0.1 ? -std::log10(bound) : 0;
}

#define CAGEPROOF_INSTANTIATE(R) template void integrate_adaptive<R>(const Integrand&, const Query<R>&, Result<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
