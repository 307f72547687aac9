// SPDX-License-Identifier: MIT
// The line form: mean value weights of a bilinear quad with gradient and Hessian, by quadrature in one dimension.
//
// For fixed v the point xi(., v) runs along a straight line, where the integral is elementary (line_moments.h); across
// the lines Gauss-Legendre panels do the rest (outer_rule.h).
#pragma once

#include "quad/mean_value/line_form/line_sums.h"
#include "quad/engine/local_frame.h"
#include "quad/engine/more_digits.h"
#include "quad/engine/seen_quad.h"
#include "quad/engine/singular_pairs.h"
#include "quad/mean_value/line_form/weight_sums.h"
#include "cageproof/core/catalogue/batch.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc {

/// Whether the point is that close to the quad, in units of the sides across the lines, or to its nearest corner, to
/// both its outermost lines or to a fold's, in units of the extent.
/// \param ends the distances of both outermost lines together
template <Scalar R>
bool is_within(double distance, const QuadFrame<R>& q, double ends, const SingularPairs<R>& singular) {
  // All lines of a quad whose sides cross may pass the point, and no pair tells.
  if (ends < distance) return true;
  // Where lines touch a crease they stay next to it: pairs are as wide as the root of the distance.
  const bool folded = is_folded(q);
  const auto touches = [&](const R& v) {
    const Vec3<R> area = LineArea<R>(q, v).c0, e = q.direction(v);
    return area.dot(area) < R(distance * distance) * e.dot(e);
  };
  const auto close = [&](const SingularPair<R>& pair) {
    return !pair.beyond && (pair.width < distance || (folded && touches(pair.centre))) && pair.centre > R(-1e-6) &&
           pair.centre < R(1 + 1e-6);
  };
  return std::ranges::any_of(singular, close) || q.a.dot(q.a) < R(distance * distance);
}

/// Where the point lies on the quad: on_quad(), which decides exactly, whatever the scalar.
template <Scalar R>
std::optional<BilinearPoint> place_on_quad(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  using W = std::conditional_t<is_multiprecision<R>, Mp200, double>;
  Quad<W> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<W>(corners[k]);
  return on_quad(q, convert<W>(point));
}

/// Nearer than this, a scalar's digits hold too little of the distance.
template <class R>
inline constexpr double kHolds = std::same_as<R, Mp50>    ? 1e-30
                                 : std::same_as<R, Mp100> ? 1e-60
                                 : std::same_as<R, Mp200> ? 1e-120
                                                          : 0x1p-46;

/// Whether a side that is not zero is so short that products of its square leave doubles' range.
inline bool has_short_side(const QuadFrame<double>& q) {
  const auto is_short = [](const Vec3<double>& side) {
    return (side.array() != 0).any() && side.cwiseAbs().maxCoeff() < 0x1p-70;
  };
  return is_short(q.e) || is_short(q.b) || is_short(q.b1) || is_short(q.e + q.w);
}

/// Whether heights, which values in the plane are proportional to, have lost digits to the end of doubles' range.
inline bool is_all_but_in_plane(const QuadFrame<double>& q, const Exponents& exponents) {
  constexpr int kLeast = -900;
  const double highest = std::max({std::abs(q.g00), std::abs(q.g01), std::abs(q.g10), std::abs(q.g11)});
  return exponents.smallest < kLeast && highest < std::ldexp(1, kLeast);
}

/// The four weights with derivatives, in the caller's order of corners; the tensors of each order one after the other.
template <class R>
struct WeightTensors {
  std::array<R, 4> value;
  std::array<R, 12> gradient;
  std::array<R, 36> hessian;
  /// How many times as large as a tensor the terms are that it is the sum of; one where they were not watched.
  double cancelled = 1;

  std::span<R> of(int order) {
    if (order == 0) return value;
    if (order == 1) return gradient;
    return hessian;
  }
};

/// Sums in a frame's units and order of corners, in the caller's.
template <int Order, class R>
void store(const WeightSums<R, Order>& sums, const FrameUnit& unit, WeightTensors<R>& weights) {
  using std::ldexp;
  for (int k = 0; k < 4; ++k) {
    const auto& from = sums.corner[k];
    const int to = unit.corner[k];
    weights.value[to] = ldexp(unit.sign * from[0], -unit.exponent);
    if constexpr (Order >= 1)
      for (int i = 0; i < 3; ++i) weights.gradient[3 * to + i] = ldexp(unit.sign * from[1 + i], -2 * unit.exponent);
    if constexpr (Order >= 2)
      for (int i = 0, entry = 4; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++entry)
          weights.hessian[9 * to + 3 * i + j] = weights.hessian[9 * to + 3 * j + i] =
              ldexp(unit.sign * from[entry], -3 * unit.exponent);
  }
}

/// On the quad the weights diverge: values are infinite, but NaN where the basis function vanishes, since the limit
/// depends on the direction there; derivatives are NaN.
template <int Order, class R>
void fill_infinite(const std::array<double, 4>& basis, WeightTensors<R>& weights) {
  for (int k = 0; k < 4; ++k)
    weights.value[k] = basis[k] != 0 ? std::numeric_limits<R>::infinity() : std::numeric_limits<R>::quiet_NaN();
  for (int o = 1; o <= Order; ++o) std::ranges::fill(weights.of(o), std::numeric_limits<R>::quiet_NaN());
}

/// Weights ([T18] Eq 11) with derivatives up to Order, to `digits` digits of the integral. On the quad they diverge:
/// values are infinite, NaN where the basis function vanishes, derivatives NaN. NaN for an input that is not finite.
/// The statement says how many lines were taken, and whether the rules across them could meet the digits.
template <int Order, Scalar R>
Statement line_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits, WeightTensors<R>& weights);

/// As line_form, in a wider scalar.
template <class W, int Order, Scalar R>
Statement line_form_in(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits,
                       WeightTensors<R>& weights) {
  std::array<Vec3<W>, 4> wide_corners;
  for (int k = 0; k < 4; ++k) wide_corners[k] = convert<W>(corners[k]);
  WeightTensors<W> wide;
  const Statement statement = line_form<Order, W>(wide_corners, convert<W>(point), digits, wide);
  for (int o = 0; o <= Order; ++o)
    for (std::size_t i = 0; i < wide.of(o).size(); ++i) weights.of(o)[i] = static_cast<R>(wide.of(o)[i]);
  weights.cancelled = wide.cancelled;
  return statement;
}

/// Sums of terms that are more than that many times as large are taken in more digits.
inline constexpr double kCancelled = 16;

/// As line_form, for points so close to the quad that differences of coordinates say too little, and for folds whose
/// sheets' terms cancel: in 50 digits or more, and to as many digits more as cancel.
/// \param cancelled how many times as large as the result its terms are known to be
template <int Order, Scalar R>
Statement line_form_in_more_digits(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits,
                                   double cancelled, WeightTensors<R>& weights) {
  // Relative to the terms, each scalar gives as many digits as its closed form is asked for, and no integral more than
  // 90. A sum that cancels completely leaves only rounding, which tells that more digits are needed, but not how many.
  constexpr double most = 90;
  return with_what_cancels(digits, most, kCancelled, cancelled, [&](double asked) -> Cancelled {
    const auto in = [&]<class W>() -> std::optional<Statement> {
      constexpr double holds = std::same_as<W, Mp50> ? 36 : 70;
      if (!std::same_as<W, Mp200> && asked > holds) return std::nullopt;
      return line_form_in<W, Order, R>(corners, point, asked, weights);
    };
    const Statement found = in_first_of<Mp50, Mp100, Mp200>(in);
    return {found, weights.cancelled};
  });
}

/// As line_form, for coordinates whose exponents are far apart.
template <int Order, Scalar R>
Statement line_form_of_distant(std::span<const Vec3<R>> corners, const Vec3<R>& point, double order, double digits,
                               WeightTensors<R>& weights) {
  Statement statement;
  if (const auto on = place_on_quad<R>(corners, point)) {
    fill_infinite<Order>(on->basis, weights);
    return statement;
  }
  WeightSums<R, Order> sums;
  std::array<Vec3<Mp200>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = convert<Mp200>(corners[k]);
  // All but in the plane, N.x vanishes next to the point, and lines far from it add the most.
  const SeenQuad seen = see_in_800_digits(wide, convert<Mp200>(point), order, digits);
  sums.watched = seen.folded;
  for (const SeenRule& rule : seen.rules) {
    statement.nodes += add_lines<Order>(LineReferences<R>(LocalFrame<R>(rule.frame)), OuterRule<R>(rule.rule),
                                        static_cast<R>(rule.centre), rule.panels, digits, sums);
    statement.converged = statement.converged && rule.rule.whole;
  }
  store<Order>(sums, seen.frame.unit, weights);
  if (seen.folded) weights.cancelled = cancellation<Order>(sums);
  return statement;
}

template <int Order, Scalar R>
Statement line_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits, WeightTensors<R>& weights) {
  Statement statement;
  weights.cancelled = 1;
  // The weights grow like 1/distance; in the line's variable their integrand has half an order more, and each
  // derivative adds one.
  constexpr double order = Order + 1.5;
  const Exponents exponents = exponents_of(corners, point);
  if constexpr (is_multiprecision<R>) {
    if (exponents.finite && exponents.are_distant())
      return line_form_of_distant<Order, R>(corners, point, order, digits, weights);
  } else {
    if (exponents.finite && exponents.are_extreme())
      return line_form_in_more_digits<Order, R>(corners, point, digits, 1, weights);
  }
  const auto q = quad_frame<R>(corners, point);
  if (!q) {
    for (int o = 0; o <= Order; ++o) std::ranges::fill(weights.of(o), std::numeric_limits<R>::quiet_NaN());
    return statement;
  }
  if constexpr (!is_multiprecision<R>) {
    if (exponents.are_distant() && (has_short_side(*q) || is_all_but_in_plane(*q, exponents)))
      return line_form_in_more_digits<Order, R>(corners, point, digits, 1, weights);
  }
  WeightSums<R, Order> sums;
  const double ends = distance_of_ends(*q);
  if (const double rho = ellipse_from_distance(*q, ends); rho >= far_across<R, Order>) {
    const Panel panel = plain_panel(rho, order, digits);
    statement.nodes =
        add_lines<Order>(LineReferences<R>(LocalFrame<R>(*q)), OuterRule<R>{}, R(0), {&panel, 1}, digits, sums);
  } else {
    const SingularPairs<R> singular = singular_pairs(*q);
    if (is_within(1e-12, *q, ends, singular)) {
      if (const auto on = place_on_quad<R>(corners, point)) {
        fill_infinite<Order>(on->basis, weights);
        return statement;
      }
    }
    if (is_within(kHolds<R>, *q, ends, singular)) {
      if constexpr (is_multiprecision<R>) return line_form_of_distant<Order, R>(corners, point, order, digits, weights);
      else return line_form_in_more_digits<Order, R>(corners, point, digits, 1, weights);
    }
    // Ordinary quads do not pay for what folds need.
    sums.watched = is_folded(*q);
    thread_local OuterRules<R> across;
    find_outer_rules(singular, order, digits, static_cast<int>(3 * digits), across);
    for (const OuterRule<R>& rule : across.rules) {
      const auto local =
          rule.plain ? LocalFrame<R>(*q) : frame_at<R>(*q, corners, point, std::clamp(rule.centre, rule.lo, rule.hi));
      statement.nodes += add_lines<Order>(LineReferences<R>(local, *q), rule, R(rule.centre - local.v0),
                                          across.panels_of(rule), digits, sums);
      statement.converged = statement.converged && rule.whole;
    }
    if (sums.watched) {
      weights.cancelled = cancellation<Order>(sums);
      if constexpr (!is_multiprecision<R>) {
        if (weights.cancelled > kCancelled)
          return line_form_in_more_digits<Order, R>(corners, point, digits, weights.cancelled, weights);
      }
    }
  }
  store<Order>(sums, q->unit, weights);
  return statement;
}

// Each scalar is compiled in a file of its own.
extern template Statement line_form<0, Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&, double,
                                             WeightTensors<Mp50>&);
extern template Statement line_form<1, Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&, double,
                                             WeightTensors<Mp50>&);
extern template Statement line_form<2, Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&, double,
                                             WeightTensors<Mp50>&);
extern template Statement line_form<0, Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&, double,
                                              WeightTensors<Mp100>&);
extern template Statement line_form<1, Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&, double,
                                              WeightTensors<Mp100>&);
extern template Statement line_form<2, Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&, double,
                                              WeightTensors<Mp100>&);
extern template Statement line_form<0, Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&, double,
                                              WeightTensors<Mp200>&);
extern template Statement line_form<1, Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&, double,
                                              WeightTensors<Mp200>&);
extern template Statement line_form<2, Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&, double,
                                              WeightTensors<Mp200>&);

}  // namespace cageproof::adaptive_qmvc
