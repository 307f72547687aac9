// SPDX-License-Identifier: MIT
// Where the integral along the lines of a bilinear quad is singular, as a function of the line.
#pragma once

#include "quad/engine/outer_rule.h"
#include "quad/engine/quad_frame.h"
#include "quad/engine/quartic_zeros.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

namespace cageproof::adaptive_qmvc {

/// a(v) x e(v) about a line v: c0 + s c1 + s^2 c2, s the step from that line; zero (in complex s) where the line meets
/// eta.
template <class R>
struct LineArea {
  Vec3<R> c0, c1, c2;

  /// About the line that goes along e from a, where the quad's normal at its start is n and grows by n_v a line.
  LineArea(const Vec3<R>& a, const Vec3<R>& e, const Vec3<R>& w, const Vec3<R>& n, const Vec3<R>& n_v)
      : c0(a.cross(e)), c1(a.cross(w) - n), c2(-n_v) {}
  LineArea(const QuadFrame<R>& q, const R& v)
      : LineArea(q.start(v), q.direction(v), q.w, Vec3<R>(q.n + v * q.n_v), q.n_v) {}
  /// a x e at a step s.
  Vec3<R> at(const R& s) const { return c0 + s * (c1 + s * c2); }
  /// Coefficients of |a x e|^2 as a polynomial in s.
  detail::Quartic<Width<R>> polynomial() const {
    using F = Width<R>;
    return {static_cast<F>(c0.dot(c0)), static_cast<F>(R(2 * c0.dot(c1))),
            static_cast<F>(R(c1.dot(c1) + 2 * c0.dot(c2))), static_cast<F>(R(2 * c1.dot(c2))),
            static_cast<F>(c2.dot(c2))};
  }
};

namespace detail {

/// A real minimum of |a x e|^2: about it the closest pair of zeros loses no digits.
template <class R>
struct Minimum {
  R centre;
  Quartic<Width<R>> p;  ///< about the centre
  Width<R> depth;       ///< how far off the axis the pair is there, to first order
  bool settled;  ///< false where the minimum is flat, so that more than a pair of zeros may be near, or was not found
};

/// The minimum next to a line, by Newton's method.
template <class R>
Minimum<R> minimum_near(const QuadFrame<R>& q, const R& line) {
  using F = Width<R>;
  // Each round adds at least as many digits as F has.
  constexpr int kRounds = std::same_as<F, double> ? 12 : 48;
  Minimum<R> m{line, {}, 0.5, false};
  for (int round = 0; round < kRounds; ++round) {
    m.p = LineArea<R>(q, m.centre).polynomial();
    if (!(m.p[2] > 0)) return m;
    const F shift = -m.p[1] / (2 * m.p[2]);
    m.depth = std::sqrt(std::max(F(0), m.p[0] / m.p[2]));
    m.settled = m.depth > 0.05 || std::abs(shift) > 0.2 || std::abs(shift) <= 1e-3 * m.depth || shift == 0;
    if (m.settled) break;
    m.centre += R(shift);
  }
  return m;
}

/// All pairs of zeros of |a x e|^2, each seen from its own line: about any other its distance from the axis may be
/// nothing but rounding. Slow, and needed where zeros come close to each other, as next to a corner whose sides lie on
/// one line: there |a x e|^2 is a constant and a fourth power.
template <class R, class Add>
void find_pairs_one_by_one(const QuadFrame<R>& q, const R& line, const Add& add) {
  using F = Width<R>;
  // Pairs seen from a line whose distance is some times theirs from the axis have digits enough.
  constexpr double kSeen = 30;
  const auto zeros_at = [&](const R& centre) { return zeros_of(LineArea<R>(q, centre).polynomial()); };
  // A pair that is all but on the axis is found more than once, at different roundings.
  constexpr int kMost = SingularPairs<R>::most_of_lines;
  std::array<SingularPair<R>, kMost> known;
  int count = 0;
  const auto add_new = [&](const SingularPair<R>& pair) {
    const auto is_same = [&](const SingularPair<R>& other) {
      return std::hypot(static_cast<F>(R(other.centre - pair.centre)), other.width - pair.width) <=
             0.1 * std::max(pair.width, other.width);
    };
    if (count == kMost || std::any_of(known.begin(), known.begin() + count, is_same)) return;
    known[count++] = pair;
    add(pair);
  };
  // From one line to the pair's own; what is found next to it is added with it.
  const auto follow = [&](R centre, Complex<F> z, QuarticZeros<F> seen) {
    for (int round = 0; round < 40 && std::abs(z.real()) > 0.01 * std::abs(z.imag()); ++round) {
      const R next = centre + R(z.real());
      if (next == centre) break;
      centre = next;
      seen = zeros_at(centre);
      const Complex<F> expected(0, std::abs(z.imag()));
      z = *std::min_element(seen.zero.begin(), seen.zero.begin() + seen.count, [&](Complex<F> a, Complex<F> b) {
        return std::norm(a - expected) < std::norm(b - expected);
      });
    }
    for (int k = 0; k < seen.count; ++k)
      if (seen.zero[k] == z || std::abs(seen.zero[k]) <= kSeen * std::abs(z))
        add_new({R(centre + R(seen.zero[k].real())), std::abs(seen.zero[k].imag())});
  };
  // One of each conjugate two; of a double zero all that rounding makes of it, which may be two of the same side.
  const auto is_sought = [](Complex<F> z, const QuarticZeros<F>& among) {
    const auto is_upper = [](Complex<F> one) { return !(one.imag() < -1e-6 * std::abs(one)); };
    const auto is_conjugate = [&](Complex<F> other) {
      return is_upper(other) && std::abs(other - std::conj(z)) <= 1e-3 * std::abs(z);
    };
    return std::abs(z) < 30 &&
           (is_upper(z) || std::none_of(among.zero.begin(), among.zero.begin() + among.count, is_conjugate));
  };
  const QuarticZeros<F> first = zeros_at(line);
  for (int i = 0; i < first.count; ++i)
    if (is_sought(first.zero[i], first)) follow(line, first.zero[i], first);
  // Two pairs much closer to each other than to that line are one to it, and all ways may have led to the same of them.
  // From there the other is as clear as its distance.
  for (int i = 0; i < count; ++i) {
    const SingularPair<R> from = known[i];
    const QuarticZeros<F> seen = zeros_at(from.centre);
    for (int k = 0; k < seen.count; ++k) {
      const Complex<F> z = seen.zero[k];
      const auto is_there = [&](const SingularPair<R>& other) {
        return std::hypot(static_cast<F>(R(other.centre - from.centre)) - z.real(), other.width - std::abs(z.imag())) <=
               0.1 * std::abs(z);
      };
      if (!is_sought(z, seen) || std::abs(z) <= kSeen * from.width) continue;
      if (std::none_of(known.begin(), known.begin() + count, is_there)) follow(from.centre, z, seen);
    }
  }
}

//// The zeros of |p + v d|^2; nothing where d is zero.
template <class R>
std::optional<SingularPair<R>> zeros_along(const Vec3<R>& p, const Vec3<R>& d) {
  using std::sqrt;
  const R square = d.dot(d);
  if (!(square > 0)) return std::nullopt;
  const Vec3<R> c = p.cross(d);
  return SingularPair<R>{R(-p.dot(d) / square), static_cast<Width<R>>(R(sqrt(c.dot(c)) / square))};
}

}  // namespace detail

/// The distance of eta from a segment from `start` (seen from eta) along `side`.
template <class R>
double distance_of_segment(const Vec3<R>& start, const Vec3<R>& side) {
  const double square = static_cast<double>(side.dot(side)), along = -static_cast<double>(start.dot(side));
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  const Vec3<R> nearest = start + R(t) * side;
  return std::sqrt(static_cast<double>(nearest.dot(nearest)));
}

/// The distances of eta from both outermost lines together.
template <class R>
double distance_of_ends(const QuadFrame<R>& q) {
  return distance_of_segment(q.a, q.e) + distance_of_segment(Vec3<R>(q.a + q.b), Vec3<R>(q.e + q.w));
}

/// A lower bound of the ellipse about [0, 1] that singularities in v lie outside of: for every u in [0, 1] the zeros of
/// r^2 along the straight line v -> xi(u, v) lie on the one whose axis is the distances of both ends over its length.
/// \param ends distance_of_ends
template <class R>
double ellipse_from_distance(const QuadFrame<R>& q, double ends) {
  const double step = std::sqrt(std::max(static_cast<double>(q.b.dot(q.b)), static_cast<double>(q.b1.dot(q.b1))));
  if (!(ends < 1e6 * step)) return 1e6;
  const double axis = ends / step;
  return axis > 1 ? axis + std::sqrt(axis * axis - 1) : 1;
}

/// The singularities that the integral along line v may have: where the two sides across the lines pass eta, and where
/// a line does. Where it does so beyond its ends, there is nothing on the axis: the integrand along the lines that end
/// before their foot is another than along those that do not, and the sides' own singularities are where they part.
template <class R>
SingularPairs<R> singular_pairs(const QuadFrame<R>& q) {
  using F = Width<R>;
  SingularPairs<R> pairs;
  // Where the sides across the lines pass eta.
  if (const auto side = detail::zeros_along(q.a, q.b)) pairs.add(*side);
  if (const auto side = detail::zeros_along(q.seen[1], q.b1)) pairs.add(*side);
  // A line without length is regular, and a branch point of the logarithm that the integrand has past another pair.
  if (auto pair = detail::zeros_along(q.e, q.w); pair && std::isfinite(pair->width)) {
    pair->beyond = true;
    pairs.add(*pair);
  }
  const auto keep = [&](SingularPair<R> pair) {
    if (!std::isfinite(pair.width)) return;
    const Vec3<R> a = q.start(pair.centre), e = q.direction(pair.centre);
    const F foot = -static_cast<F>(a.dot(e)) / static_cast<F>(e.dot(e));
    // The foot's real part, to first order in the width.
    const F margin = std::min(F(0.3), 4 * pair.width);
    pair.beyond = !(foot >= -margin && foot <= 1 + margin);
    pairs.add(pair);
  };
  const auto p = LineArea<R>(q, R(0)).polynomial();
  const F size = p[0] + std::abs(p[2]) + p[4];
  if (!(size > 0)) return pairs;
  // Next to the real axis roots are found from the real minima, which stay accurate however close the pair is.
  std::array<double, 3> turns;
  // The coefficients' common size does not matter, except that they must fit into double's range.
  const auto scaled = [&](F x) { return static_cast<double>(std::same_as<F, double> ? x : x / size); };
  const int count = detail::zeros_within({scaled(p[1]), 2 * scaled(p[2]), 3 * scaled(p[3]), 4 * scaled(p[4])}, turns);
  const auto bend = [&](F v) { return 2 * p[2] + v * (6 * p[3] + v * 12 * p[4]); };
  R centre(0.5);
  F lowest = std::numeric_limits<F>::infinity();
  for (int i = 0; i < count; ++i) {
    const F v = turns[i], value = p[0] + v * (p[1] + v * (p[2] + v * (p[3] + v * p[4])));
    if (!(bend(v) > 0) || !(value / bend(v) < lowest)) continue;
    lowest = value / bend(v);
    centre = R(v);
  }
  const auto one_by_one = [&] {
    detail::find_pairs_one_by_one(q, centre, keep);
    return pairs;
  };
  const auto m = detail::minimum_near(q, centre);
  if (!m.settled) return one_by_one();
  const auto add_pair = [&](const R& about, F r, F t) {
    keep({R(about - R(r / 2)), std::sqrt(std::max(F(0), t - r * r / 4))});
  };
  if (p[4] < 1e-26 * size) {
    add_pair(m.centre, m.p[1] / m.p[2], m.p[0] / m.p[2]);
    return pairs;
  }
  const std::optional<detail::Factors<F>> f =
      m.p[0] == 0 ? detail::Factors<F>{0, 0, m.p[4], m.p[3], m.p[2]} : detail::factors_of(m.p, m.depth * m.depth);
  if (!f) return one_by_one();
  const F r = f->linear / f->lead, t = f->constant / f->lead;
  // Division by larger zeros leaves only rounding of smaller ones.
  if (!(t >= f->t / 4)) return one_by_one();
  // The other pair. A pair that is on the axis up to rounding is looked for around its own minimum, which a third root
  // next to it would displace.
  if (!(t < 900) || t - r * r / 4 > 1e-7) {
    add_pair(m.centre, f->r, f->t);
    if (t < 900) add_pair(m.centre, r, t);
    return pairs;
  }
  const auto other = detail::minimum_near(q, R(m.centre - R(r / 2)));
  if (!other.settled || !(other.depth * (std::abs(other.p[3]) + other.depth * other.p[4]) < other.p[2] / 4))
    return one_by_one();
  add_pair(m.centre, f->r, f->t);
  add_pair(other.centre, 0, other.depth * other.depth);
  return pairs;
}

}  // namespace cageproof::adaptive_qmvc
