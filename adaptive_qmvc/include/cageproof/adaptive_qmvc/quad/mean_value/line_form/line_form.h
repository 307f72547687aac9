// SPDX-License-Identifier: MIT
// The line form: mean value weights of a bilinear quad with gradient and Hessian, by quadrature in one dimension.
//
// For fixed v the point xi(., v) runs along a straight line, where the integral is elementary (line_moments.h); across
// the lines Gauss-Legendre panels do the rest (outer_rule.h).
#pragma once

#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/line_moments.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/line_values.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/local_frame.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/seen_quad.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/singular_pairs.h"
#include "cageproof/core/batch.h"
#include "cageproof/core/quad_geometry.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc {

/// The weights' sums over lines: for each corner value, gradient, Hessian (xx, xy, xz, yy, yz, zz).
template <class R, int Order>
struct WeightSums {
  static constexpr int entries = Order == 0 ? 1 : Order == 1 ? 4 : 10;
  std::array<std::array<R, entries>, 4> corner{};
};

/// Adds one line, all of whose entries are multiplied with `weight`.
/// \param s the line's step from the frame's
template <int Order, class R>
void add_line(const LocalFrame<R>& q, const LineArea<R>& area, const R& s, const R& weight, double digits,
              WeightSums<R, Order>& sums) {
  using std::sqrt;
  const Vec3<R> a = q.start(s), e = q.direction(s);
  const R &first = q.first, &last = q.last;
  const Vec3<R> start = a + first * e, end = a + last * e;
  using F = std::conditional_t<is_multiprecision<R>, long double, double>;
  const F length2 = static_cast<F>(e.dot(e)), start2 = static_cast<F>(start.dot(start)),
          end2 = static_cast<F>(end.dot(end));
  // Where the ends' distances sum up to `kFarAlongLine` lengths; their squares alone often tell.
  const auto ends = [&] { return static_cast<double>((std::sqrt(start2) + std::sqrt(end2)) / std::sqrt(length2)); };
  LineMoments<R> m;
  Vec3<R> x;  // the line's point at the moments' origin
  if (2 * (start2 + end2) < kFarAlongLine * kFarAlongLine * length2 || ends() < kFarAlongLine) {
    const Vec3<R> c = area.at(s);
    m = moments_about_foot<Order>(a, e, first, last, R(c.dot(c)), digits);
    // Not a + origin e, whose terms cancel where the foot is far along the line.
    if constexpr (Order >= 1) x = e.cross(c) / e.dot(e);
  } else {
    m = moments_by_gauss<Order>(a, e, first, gauss_rule<R>(length2 > 0 ? nodes_along_line(ends(), Order, digits) : 2));
    if constexpr (Order >= 1) x = a + m.origin * e;
  }
  const R g1 = q.g10 + s * q.g11;
  const R g0 = q.g00 + s * q.g01 + m.origin * g1;
  // f0 and f1: the integrals of the kernel and of s times the kernel.
  std::array<std::array<R, WeightSums<R, Order>::entries>, 2> f;
  for (int c = 0; c < 2; ++c) f[c][0] = g0 * m.p2[c] + g1 * m.p2[c + 1];
  if constexpr (Order >= 1) {
    const Vec3<R>& n1 = q.n_u;
    const Vec3<R> n0 = q.n + s * q.n_v + m.origin * n1;
    for (int c = 0; c < 2; ++c) {
      const R h0 = g0 * m.p3[c] + g1 * m.p3[c + 1], h1 = g0 * m.p3[c + 1] + g1 * m.p3[c + 2];
      for (int i = 0; i < 3; ++i) f[c][1 + i] = 4 * (x[i] * h0 + e[i] * h1) - (n0[i] * m.p2[c] + n1[i] * m.p2[c + 1]);
      if constexpr (Order >= 2) {
        const R k0 = 24 * (g0 * m.p4[c] + g1 * m.p4[c + 1]), k1 = 24 * (g0 * m.p4[c + 1] + g1 * m.p4[c + 2]),
                k2 = 24 * (g0 * m.p4[c + 2] + g1 * m.p4[c + 3]);
        // The symmetric products of x and of e with what follows.
        const Vec3<R> by_x = (k0 / 2) * x + k1 * e - 4 * (m.p3[c] * n0 + m.p3[c + 1] * n1);
        const Vec3<R> by_e = (k2 / 2) * e - 4 * (m.p3[c + 1] * n0 + m.p3[c + 2] * n1);
        for (int i = 0, entry = 4; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++entry) {
            f[c][entry] = x[i] * by_x[j] + x[j] * by_x[i] + e[i] * by_e[j] + e[j] * by_e[i];
            if (i == j) f[c][entry] -= 4 * h0;
          }
      }
    }
  }
  const R right = weight * (q.v0 + s), left = weight - right;
  const R along = q.u0 + m.origin, rest = last - m.origin;
  for (int k = 0; k < WeightSums<R, Order>::entries; ++k) {
    const R far = along * f[0][k] + f[1][k], near = rest * f[0][k] - f[1][k];
    sums.corner[0][k] += left * near;
    sums.corner[1][k] += left * far;
    sums.corner[2][k] += right * far;
    sums.corner[3][k] += right * near;
  }
}

/// Adds a panel's lines for values in double, in packs of four; those of weight zero fill the last one.
inline void add_values(const LocalFrame<double>& q, const LineArea<double>& area, const OuterRule<double>& rule,
                       double centre, double lo, double hi, const GaussLegendre<double>& gauss, double digits,
                       LineValues& values, WeightSums<double, 0>& sums) {
  const int count = static_cast<int>(gauss.nodes.size());
  for (int first = 0; first < count; first += 4) {
    Lines at, weight;
    for (int i = 0; i < 4; ++i) {
      const int k = std::min(first + i, count - 1);
      at[i] = gauss.nodes[k];
      weight[i] = first + i < count ? gauss.weights[k] : 0;
    }
    at = lo + (hi - lo) * at;
    weight *= hi - lo;
    Lines s = at - q.v0;
    if (!rule.plain) {
      // sinh and cosh: what their difference cancels is below the roundings of the width.
      const Lines grown = (rule.width / 2) * at.exp(), shrunk = (rule.width / 2) * (-at).exp();
      s = centre + (grown - shrunk);
      weight *= grown + shrunk;
    }
    if (values.add(s, weight)) continue;
    for (int i = 0; i < 4 && first + i < count; ++i) add_line<0, double>(q, area, s[i], weight[i], digits, sums);
  }
}

/// Adds all lines of a rule. Returns how many.
/// \param q about a point of the lines next to which the rule's are dense
/// \param centre the rule's, as a step from the frame's line
template <int Order, class R>
std::size_t add_lines(const LocalFrame<R>& q, const OuterRule<R>& rule, const R& centre, std::span<const Panel> panels,
                      double digits, WeightSums<R, Order>& sums) {
  constexpr bool values_only = Order == 0 && std::same_as<R, double>;
  const LineArea<R> area(q.a, q.e, q.w, q.n, q.n_v);
  std::size_t lines = 0;
  [[maybe_unused]] std::conditional_t<values_only, LineValues, std::nullptr_t> values = [&] {
    if constexpr (values_only) return LineValues(q, area, digits);
    else return nullptr;
  }();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Panel& panel = panels[p];
    const R lo = p == 0 ? rule.first : R(panel.lo), hi = p + 1 == panels.size() ? rule.last : R(panel.hi);
    const GaussLegendre<R>& gauss = gauss_rule<R>(panel.nodes);
    lines += panel.nodes;
    if constexpr (values_only) {
      add_values(q, area, rule, centre, lo, hi, gauss, digits, values, sums);
      continue;
    }
    for (int i = 0; i < panel.nodes; ++i) {
      const R at = lo + (hi - lo) * gauss.nodes[i];
      R weight = (hi - lo) * gauss.weights[i];
      if (rule.plain) {
        add_line(q, area, R(at - q.v0), weight, digits, sums);
        continue;
      }
      using std::exp;
      const R grown = rule.width / 2 * exp(at), shrunk = rule.width * rule.width / (4 * grown);
      weight *= grown + shrunk;
      add_line(q, area, R(centre + (grown - shrunk)), weight, digits, sums);
    }
  }
  if constexpr (values_only) {
    const std::array<double, 4> corners = values.corners();
    for (int k = 0; k < 4; ++k) sums.corner[k][0] += corners[k];
  }
  return lines;
}

/// Whether the point is that close to the quad, in units of the sides across the lines, or to its nearest corner, in
/// units of the extent.
template <Scalar R>
bool is_within(double distance, const QuadFrame<R>& q, const SingularPairs<R>& singular) {
  const auto close = [&](const SingularPair<R>& pair) {
    return !pair.beyond && pair.width < distance && pair.centre > R(-1e-6) && pair.centre < R(1 + 1e-6);
  };
  return std::ranges::any_of(singular, close) || q.a.dot(q.a) < R(distance * distance);
}

/// Where the point lies on the quad, exactly, for inputs that are doubles; others are taken to be off it.
template <Scalar R>
std::optional<BilinearPoint> place_on_quad(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  Quad<double> q;
  Vec3<double> eta;
  for (int i = 0; i < 3; ++i) {
    eta[i] = static_cast<double>(point[i]);
    if (R(eta[i]) != point[i]) return std::nullopt;
    for (int k = 0; k < 4; ++k) {
      q[k][i] = static_cast<double>(corners[k][i]);
      if (R(q[k][i]) != corners[k][i]) return std::nullopt;
    }
  }
  return on_quad(q, eta);
}

/// Nearer than this, doubles hold too little of the distance.
inline constexpr double kDoubleHolds = 0x1p-46;

/// Whether a side that is not zero is so short that products of its square leave doubles' range.
inline bool has_short_side(const QuadFrame<double>& q) {
  const auto is_short = [](const Vec3<double>& side) {
    return (side.array() != 0).any() && side.cwiseAbs().maxCoeff() < 0x1p-70;
  };
  return is_short(q.e) || is_short(q.b) || is_short(q.b1) || is_short(q.e + q.w);
}

/// The four weights with derivatives, in the caller's order of corners; the tensors of each order one after the other.
template <class R>
struct WeightTensors {
  std::array<R, 4> value;
  std::array<R, 12> gradient;
  std::array<R, 36> hessian;

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

/// As line_form, for points so close to the quad that differences of coordinates say too little.
template <int Order, Scalar R>
Statement line_form_in_50_digits(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits,
                                 WeightTensors<R>& weights) {
  std::array<Vec3<Mp50>, 4> wide_corners;
  for (int k = 0; k < 4; ++k) wide_corners[k] = convert<Mp50>(corners[k]);
  WeightTensors<Mp50> wide;
  const Statement statement = line_form<Order, Mp50>(wide_corners, convert<Mp50>(point), digits, wide);
  for (int o = 0; o <= Order; ++o)
    for (std::size_t i = 0; i < wide.of(o).size(); ++i) weights.of(o)[i] = static_cast<R>(wide.of(o)[i]);
  return statement;
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
  const SeenQuad seen = see_in_800_digits(wide, convert<Mp200>(point), order, digits);
  for (const SeenRule& rule : seen.rules) {
    statement.nodes += add_lines<Order>(LocalFrame<R>(rule.frame), OuterRule<R>(rule.rule), static_cast<R>(rule.centre),
                                        rule.panels, digits, sums);
    statement.converged = statement.converged && rule.rule.whole;
  }
  store<Order>(sums, seen.unit, weights);
  return statement;
}

template <int Order, Scalar R>
Statement line_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, double digits, WeightTensors<R>& weights) {
  Statement statement;
  // The weights grow like 1/distance; in the line's variable their integrand has half an order more, and each
  // derivative adds one.
  constexpr double order = Order + 1.5;
  const Exponents exponents = exponents_of(corners, point);
  if constexpr (is_multiprecision<R>) {
    if (exponents.finite && exponents.are_distant())
      return line_form_of_distant<Order, R>(corners, point, order, digits, weights);
  } else {
    if (exponents.finite && exponents.are_extreme())
      return line_form_in_50_digits<Order, R>(corners, point, digits, weights);
  }
  const auto q = quad_frame<R>(corners, point);
  if (!q) {
    for (int o = 0; o <= Order; ++o) std::ranges::fill(weights.of(o), std::numeric_limits<R>::quiet_NaN());
    return statement;
  }
  if constexpr (!is_multiprecision<R>) {
    if (exponents.are_distant() && has_short_side(*q))
      return line_form_in_50_digits<Order, R>(corners, point, digits, weights);
  }
  WeightSums<R, Order> sums;
  if (const double rho = ellipse_from_distance(*q); rho >= far_across<R, Order>) {
    const Panel panel = plain_panel(rho, order, digits);
    statement.nodes = add_lines<Order>(LocalFrame<R>(*q), OuterRule<R>{}, R(0), {&panel, 1}, digits, sums);
  } else {
    const SingularPairs<R> singular = singular_pairs(*q);
    if (is_within(1e-12, *q, singular)) {
      if (const auto on = place_on_quad<R>(corners, point)) {
        fill_infinite<Order>(on->basis, weights);
        return statement;
      }
    }
    if constexpr (!is_multiprecision<R>) {
      if (is_within(kDoubleHolds, *q, singular))
        return line_form_in_50_digits<Order, R>(corners, point, digits, weights);
    }
    thread_local OuterRules<R> across;
    find_outer_rules(singular, order, digits, static_cast<int>(3 * digits), across);
    for (const OuterRule<R>& rule : across.rules) {
      const auto local =
          rule.plain ? LocalFrame<R>(*q) : frame_at<R>(*q, corners, point, std::clamp(rule.centre, rule.lo, rule.hi));
      statement.nodes += add_lines<Order>(local, rule, R(rule.centre - local.v0), across.panels_of(rule), digits, sums);
      statement.converged = statement.converged && rule.whole;
    }
  }
  store<Order>(sums, q->unit, weights);
  return statement;
}

}  // namespace cageproof::adaptive_qmvc
