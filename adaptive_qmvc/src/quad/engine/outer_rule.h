// SPDX-License-Identifier: MIT
// The rules across the lines of a bilinear quad: substitutions that take the near singularities away, and as many Gauss
// points as a bound asks for.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// The type that holds widths, their squares and products: double, or numbers whose exponents suit the widest scalar.
template <class R>
using Width = std::conditional_t<std::same_as<R, Mp800>, long double, double>;

/// A pair v = centre +- i width of conjugate singularities of the integrand across the lines.
template <class R>
struct SingularPair {
  R centre;
  Width<R> width;
  bool beyond = false;  ///< the integrand has it only where it is continued past another one
};

/// One of each side across the lines, one where lines have no length, and two where lines pass the point, or up to
/// eight that rounding makes of these.
template <class R>
struct SingularPairs {
  static constexpr int most_of_lines = 8, most = most_of_lines + 3;
  std::array<SingularPair<R>, most> pair;
  int count = 0;
  void add(const SingularPair<R>& p) { pair[count++] = p; }
  const SingularPair<R>* begin() const { return pair.data(); }
  const SingularPair<R>* end() const { return pair.data() + count; }
};

/// One Gauss-Legendre panel.
struct Panel {
  double lo, hi;
  int nodes;
};

/// Gauss-Legendre panels in s, v = centre + width sinh s; or, where `plain`, in v itself.
template <class R>
struct OuterRule {
  bool plain = true;
  R centre = R(0), width = R(1);
  R lo = R(0), hi = R(1);  ///< its part of [0, 1]
  /// Steps from the centre to both ends: once all are rounded to another scalar, the ends less the centre are not
  /// these.
  R to_lo = R(0), to_hi = R(1);
  R first = R(0), last = R(1);     ///< s (or v) at both ends of its part; the outermost panels end there exactly
  bool whole = true;               ///< no panel has fewer nodes than its bound asks for
  std::size_t begin = 0, end = 0;  ///< its panels among those of OuterRules

  OuterRule() = default;
  /// The same in another scalar.
  template <class From>
  explicit OuterRule(const OuterRule<From>& r)
      : plain(r.plain),
        centre(r.centre),
        width(r.width),
        lo(r.lo),
        hi(r.hi),
        to_lo(r.to_lo),
        to_hi(r.to_hi),
        first(r.first),
        last(r.last),
        whole(r.whole),
        begin(r.begin),
        end(r.end) {}
};

/// Rules that cover [0, 1] together. One object serves many points, so that its memory is allocated once.
template <class R>
struct OuterRules {
  std::vector<OuterRule<R>> rules;
  std::vector<Panel> panels;

  std::span<const Panel> panels_of(const OuterRule<R>& rule) const {
    return std::span(panels).subspan(rule.begin, rule.end - rule.begin);
  }
};

/// Sum of the half axes of the ellipse with foci lo, hi through z, over half the distance of the foci.
inline double ellipse_through(double lo, double hi, std::complex<double> z) {
  const double half = (hi - lo) / 2;
  const double axis = (std::sqrt(std::norm(z - lo)) + std::sqrt(std::norm(z - hi))) / (2 * half);
  return axis + std::sqrt(std::max(0.0, axis * axis - 1));
}

/// The Gauss-Legendre nodes for `digits` digits relative to the largest |f|, with most of a digit to spare for sums
/// that cancel, on a panel of half length `half`. The integrand is analytic inside the ellipse `rho`, grows at most
/// like exp(growth |Re s|) (quadratically, for growth 0) and like distance^-order to its singularities. The least over
/// smaller ellipses of the n with max|f| rho^(-2n) <= 10^-digits.
inline int nodes_across(double rho, double half, double growth, double order, double digits) {
  double least = 1e6;
  const double whole = std::log(std::min(rho, 1e6));
  for (const double part : {0.96, 0.85, 0.5}) {
    const double log_rho = part * whole;
    // Each derivative makes the integrand's bound that much larger.
    const double blow_up = 0.4 * order + 0.4 - order * std::log10(1 - part);
    const double reach = std::cosh(log_rho);
    // A basis function times N.x is of degree two; in s, what grows does so by `growth`.
    const double grown = growth == 0 ? 2 * std::log((1 + reach) / 2) : growth * half * (reach - 1);
    least = std::min(least, ((digits + blow_up) * std::numbers::ln10 + grown) / (2 * log_rho));
  }
  return std::max(2, static_cast<int>(std::ceil(least)));
}

/// The least width whose square does not underflow: rules next to narrower singularities state that they miss digits.
template <class F>
inline constexpr F kNarrowest = 1e-150;
template <>
inline constexpr long double kNarrowest<long double> = 1e-2000L;

/// Digits that a panel needs: far from the singularity it adds less to the whole, a digit less per factor of ten of the
/// distance, and needs as many digits less, but no fewer than a double has.
inline double digits_at(double s, double digits) {
  constexpr double kLeast = 17;
  return std::max(std::min(digits, kLeast), digits - std::abs(s) * std::numbers::log10e);
}

/// The plain rule is taken from this ellipse on, where it gains a digit per node.
inline constexpr double kFarAcross = 3.2;

/// Values in double have so cheap lines that more of them cost less than the search for singularities.
template <class R, int Order>
inline constexpr double far_across = Order == 0 && std::same_as<R, double> ? 1.8 : kFarAcross;

/// nodes_across on [0, 1], for an integrand analytic inside the ellipse through a singularity whose distances from both
/// ends sum up to `axis` >= 1.
inline int plain_nodes(double axis, double order, double digits) {
  // By small steps, remembered: the bound costs more than a line.
  constexpr int kSteps = 64, kEntries = 1024, kOrders = 10;
  struct Known {
    double digits = 0;
    std::array<std::int16_t, kEntries> nodes{};
  };
  thread_local std::array<Known, kOrders> all;
  Known& known = all[static_cast<int>(2 * order)];
  if (known.digits != digits) known = {digits, {}};
  const int step = static_cast<int>(std::min<double>(kSteps * axis, kEntries - 1));
  std::int16_t& nodes = known.nodes[step];
  if (nodes == 0) {
    const double least = std::max(1.001, static_cast<double>(step) / kSteps);
    nodes = static_cast<std::int16_t>(nodes_across(least + std::sqrt(least * least - 1), 0.5, 0, order, digits));
  }
  return nodes;
}

/// The panel of the plain rule, Gauss-Legendre in v itself, for an integrand analytic inside the ellipse `rho`.
inline Panel plain_panel(double rho, double order, double digits) {
  return {0, 1, plain_nodes((rho + 1 / rho) / 2, order, digits)};
}

/// asinh of z, |z| such that its square is in F's range, without the library's care for infinities.
template <class F>
std::complex<F> inverse_sinh(std::complex<F> z) {
  if (z.real() < 0) return -inverse_sinh(-z);
  // sqrt(z^2 + 1) with a real part >= 0; of z = -0 + i y as of i y, the sign is that of y.
  const F x = (z.real() - z.imag()) * (z.real() + z.imag()) + 1, y = 2 * z.real() * z.imag();
  const F size = std::sqrt(x * x + y * y);
  const F re = std::sqrt(std::max(F(0), (size + x) / 2)),
          im = std::copysign(std::sqrt(std::max(F(0), (size - x) / 2)), z.imag());
  const F u = z.real() + re, v = z.imag() + im;
  return {std::log(u * u + v * v) / 2, std::atan2(v, u)};
}

namespace detail {

/// How far a pair is from [lo, hi] in v, its width included.
template <class R>
Width<R> distance_of_pair(const SingularPair<R>& pair, const R& lo, const R& hi) {
  using F = Width<R>;
  return std::max({F(0), static_cast<F>(R(lo - pair.centre)), static_cast<F>(R(pair.centre - hi))}) + pair.width;
}

/// Where to cut [lo, hi] so that a pair which the map about `dominant` would leave next to the axis gets a map of its
/// own; nothing where all are wide there.
template <class R>
std::optional<R> cut_between(const SingularPairs<R>& singular, const SingularPair<R>& dominant, const R& lo,
                             const R& hi) {
  constexpr double kNarrow = 0.2;
  std::optional<R> cut;
  double narrowest = kNarrow;
  for (const auto& pair : singular) {
    const Width<R> gap = std::abs(static_cast<Width<R>>(R(pair.centre - dominant.centre)));
    const R middle = (pair.centre + dominant.centre) / 2;
    const auto narrow = static_cast<double>(distance_of_pair(pair, lo, hi) / gap);
    if (&pair == &dominant || pair.beyond || !(narrow < narrowest) || !(middle > lo) || !(middle < hi)) continue;
    narrowest = narrow;
    cut = middle;
  }
  return cut;
}

}  // namespace detail

/// Adds the rules of [lo, hi] for `digits` digits of an integrand with singularities of that order; panels have at most
/// about `most` nodes.
/// \param decays whether what is far from the singularity adds less to the integral, as digits_at() says
template <class R>
void add_rules(const SingularPairs<R>& singular, const R& lo_v, const R& hi_v, double order, double digits, int most,
               bool decays, OuterRules<R>& out) {
  double nearest = std::numeric_limits<double>::infinity();
  const SingularPair<R>* dominant = nullptr;
  const R length = hi_v - lo_v;
  for (const auto& pair : singular) {
    if (pair.beyond) continue;
    const R along = (pair.centre - lo_v) / length;
    const auto width = static_cast<double>(pair.width / static_cast<Width<R>>(length));
    const double rho = ellipse_through(0, 1, {static_cast<double>(along), width});
    // Next to the axis ellipses are rounding.
    const bool nearer =
        dominant && std::max(rho, nearest) < 1 + 1e-6
            ? detail::distance_of_pair(pair, lo_v, hi_v) < detail::distance_of_pair(*dominant, lo_v, hi_v)
            : rho < nearest;
    if (!nearer) continue;
    nearest = rho;
    dominant = &pair;
  }
  if (dominant && nearest < kFarAcross) {
    if (const auto cut = detail::cut_between(singular, *dominant, lo_v, hi_v)) {
      add_rules(singular, lo_v, *cut, order, digits, most, decays, out);
      add_rules(singular, *cut, hi_v, order, digits, most, decays, out);
      return;
    }
  }
  OuterRule<R>& rule = out.rules.emplace_back();
  rule.begin = out.panels.size();
  rule.lo = lo_v;
  rule.hi = hi_v;
  if (!dominant || nearest >= kFarAcross) {
    out.panels.push_back(plain_panel(nearest, order, digits));
    rule.end = out.panels.size();
    rule.first = rule.to_lo = lo_v;
    rule.last = rule.to_hi = hi_v;
    return;
  }
  using std::asinh;
  rule.plain = false;
  rule.centre = dominant->centre;
  rule.to_lo = lo_v - rule.centre;
  rule.to_hi = hi_v - rule.centre;
  // Beside the interval, a map as sharp as the singularity would only stretch rounding errors.
  using F = Width<R>;
  const F outside = detail::distance_of_pair<R>({dominant->centre, 0}, lo_v, hi_v);
  const F width = std::hypot(std::max(dominant->width, kNarrowest<F>), outside);
  rule.whole = width > 2 * kNarrowest<F>;
  rule.width = R(width);
  rule.first = asinh(R((lo_v - rule.centre) / rule.width));
  rule.last = asinh(R((hi_v - rule.centre) / rule.width));
  std::array<std::complex<double>, 2 * SingularPairs<R>::most> images;
  std::size_t count = 0;
  for (const auto& pair : singular) {
    const std::complex<F> z{static_cast<F>(R((pair.centre - rule.centre) / rule.width)), pair.width / width};
    const std::complex<double> image = z == std::complex<F>(0, 1) ? std::complex<double>(0, std::numbers::pi / 2)
                                                                  : std::complex<double>(inverse_sinh(z));
    // Above |Im s| = pi/2 the integrand is continued past the dominant pair: half around it, and all around.
    images[count++] = pair.beyond ? std::complex<double>(image.real(), 2 * std::numbers::pi - image.imag()) : image;
    images[count++] = std::complex<double>(0, std::numbers::pi) - image;
  }
  const auto add = [&](const auto& self, double lo, double hi) -> void {
    double rho = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) rho = std::min(rho, ellipse_through(lo, hi, images[i]));
    const double nearest_s = lo < 0 && hi > 0 ? 0 : std::min(std::abs(lo), std::abs(hi));
    const int nodes = nodes_across(rho, (hi - lo) / 2, 2, order, decays ? digits_at(nearest_s, digits) : digits);
    // Singularities on the interval itself have no rule; the panels end somewhere, and say so.
    if (nodes <= most || hi - lo < 1e-4) {
      out.panels.push_back({lo, hi, std::min(nodes, 2 * most)});
      rule.whole = rule.whole && nodes <= 2 * most;
      return;
    }
    const double middle = (lo + hi) / 2;
    self(self, lo, middle);
    self(self, middle, hi);
  };
  const double lo = static_cast<double>(rule.first), hi = static_cast<double>(rule.last);
  // Cut at the singularity first: panels are longer the further they are from it.
  if (lo < 0 && hi > 0 &&
      nodes_across(ellipse_through(lo, hi, {0, std::numbers::pi / 2}), (hi - lo) / 2, 2, order, digits) > most) {
    const double half = std::min({1.0, -lo, hi});
    if (-lo > half) add(add, lo, -half);
    add(add, -half, half);
    if (hi > half) add(add, half, hi);
  } else {
    add(add, lo, hi);
  }
  rule.end = out.panels.size();
}

/// Replaces what `out` holds by the rules of [0, 1].
template <class R>
void find_outer_rules(const SingularPairs<R>& singular, double order, double digits, int most, OuterRules<R>& out,
                      bool decays = true) {
  out.rules.clear();
  out.panels.clear();
  add_rules(singular, R(0), R(1), order, digits, most, decays, out);
}

}  // namespace cageproof::adaptive_qmvc
