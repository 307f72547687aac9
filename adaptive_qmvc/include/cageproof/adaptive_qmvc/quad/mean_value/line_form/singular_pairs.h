// SPDX-License-Identifier: MIT
// Where the integral along the lines of a bilinear quad is singular, as a function of the line.
#pragma once

#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/quad_frame.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/outer_rule.h"

#include <complex>

namespace cageproof::adaptive_qmvc {

/// a(v) x e(v) about a line v: c0 + s c1 + s^2 c2, s the step from that line; zero (in complex s) where the line meets
/// eta.
template <class R>
struct LineArea {
  Vec3<R> c0, c1, c2;

  LineArea(const Vec3<R>& a, const Vec3<R>& e, const Vec3<R>& b, const Vec3<R>& w)
      : c0(a.cross(e)), c1(b.cross(e) + a.cross(w)), c2(b.cross(w)) {}
  LineArea(const QuadFrame<R>& q, const R& v) : LineArea(q.start(v), q.direction(v), q.b, q.w) {}
  /// |a x e|^2 at a step s.
  R square(const R& s) const {
    const Vec3<R> c = c0 + s * (c1 + s * c2);
    return c.dot(c);
  }
  /// Coefficients of |a x e|^2 as a polynomial in s.
  std::array<double, 5> polynomial() const {
    return {static_cast<double>(c0.dot(c0)), static_cast<double>(R(2 * c0.dot(c1))),
            static_cast<double>(R(c1.dot(c1) + 2 * c0.dot(c2))), static_cast<double>(R(2 * c1.dot(c2))),
            static_cast<double>(c2.dot(c2))};
  }
};

namespace detail {

using Complex = std::complex<double>;

struct Derivatives {
  Complex f, df, ddf;
};

// Without the library's care for infinities, which costs more than the iterations.
inline Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
inline Complex quotient(Complex a, Complex b) { return product(a, std::conj(b)) / std::norm(b); }

inline Derivatives at(const std::array<double, 5>& p, Complex z) {
  Derivatives d{p[4], 0, 0};
  for (int k = 3; k >= 0; --k) {
    d.ddf = product(d.ddf, z) + d.df;
    d.df = product(d.df, z) + d.f;
    d.f = product(d.f, z) + p[k];
  }
  d.ddf *= 2;
  return d;
}

/// A root of a quartic by Laguerre's iteration.
inline Complex root_of(const std::array<double, 5>& p, Complex z) {
  for (int i = 0; i < 40; ++i) {
    const auto [f, df, ddf] = at(p, z);
    if (f == 0.0) break;
    const Complex g = quotient(df, f), h = product(g, g) - quotient(ddf, f);
    const Complex root = std::sqrt(3.0 * (4.0 * h - product(g, g)));
    const Complex below = std::norm(g + root) > std::norm(g - root) ? g + root : g - root;
    if (below == 0.0) break;
    const Complex step = quotient(4.0, below);
    z -= step;
    if (std::norm(step) < 1e-14 * std::norm(z)) break;  // the next would be below rounding
  }
  return z;
}

/// s^2 + r s + t, and what is left of a quartic: lead s^2 + linear s + constant.
struct Factors {
  double r, t, lead, linear, constant;
};

/// The real quadratic factors of a quartic next to s^2 + t, by Bairstow's iteration, or through one of its roots.
inline Factors factors_of(const std::array<double, 5>& p, double t) {
  double r = 0;
  for (int i = 0; i < 12; ++i) {
    const double b4 = p[4], b3 = p[3] - r * b4, b2 = p[2] - r * b3 - t * b4, b1 = p[1] - r * b2 - t * b3,
                 b0 = p[0] - r * b1 - t * b2;
    const double c3 = b3 - r * b4, c2 = b2 - r * c3 - t * b4, c1 = b1 - r * c2 - t * c3;
    const double inverse = 1 / (c2 * c2 - c1 * c3);
    const double dr = (b1 * c2 - b0 * c3) * inverse, dt = (b0 * c2 - b1 * c1) * inverse;
    r += dr;
    t += dt;
    if (!std::isfinite(r + t)) break;
    if (dr * dr < 1e-10 * std::abs(t) && std::abs(dt) < 1e-5 * std::abs(t)) {
      const double linear = p[3] - r * p[4];
      return {r, t, p[4], linear, p[2] - r * linear - t * p[4]};
    }
  }
  const Complex z = root_of(p, {0.1, 0.5});
  r = -2 * z.real();
  t = std::norm(z);
  const double linear = p[3] - r * p[4];
  return {r, t, p[4], linear, p[2] - r * linear - t * p[4]};
}

/// Moves to the real minimum of |a x e|^2 next to a line, where the closest pair of zeros loses no digits. Returns how
/// far off the axis that pair is there, to first order.
template <class R>
double settle(const QuadFrame<R>& q, R& centre, std::array<double, 5>& p) {
  double depth = 0.5;
  for (int round = 0; round < 12; ++round) {
    p = LineArea<R>(q, centre).polynomial();
    if (!(p[2] > 0)) return depth;
    const double shift = -p[1] / (2 * p[2]);
    depth = std::sqrt(std::max(0.0, p[0] / p[2]));
    if (depth > 0.05 || std::abs(shift) > 0.2 || std::abs(shift) <= 1e-3 * depth || shift == 0) break;
    centre += R(shift);
  }
  return depth;
}

/// Real zeros of c0 + c1 v + c2 v^2 + c3 v^3 within [-1, 2] to three digits, by bisection between those of its
/// derivatives: at most three.
inline int zeros_within(const std::array<double, 4>& c, std::array<double, 3>& zeros) {
  const auto value = [&](double v) { return c[0] + v * (c[1] + v * (c[2] + v * c[3])); };
  std::array<double, 4> ends{-1, 2, 2, 2};
  int pieces = 1;
  const double a = 3 * c[3], b = 2 * c[2], d = b * b - 4 * a * c[1];
  if (d > 0) {
    const double t = -(b + std::copysign(std::sqrt(d), b)) / 2;
    double first = t / a, second = c[1] / t;
    if (!(first < second)) std::swap(first, second);
    pieces = 0;
    for (const double turn : {first, second, 2.0})
      if (turn > ends[pieces] && turn <= 2) ends[++pieces] = turn;
  }
  int count = 0;
  for (int i = 0; i < pieces; ++i) {
    double lo = ends[i], hi = ends[i + 1];
    const bool rising = value(hi) > value(lo);
    if ((value(lo) > 0) == (value(hi) > 0)) continue;
    for (int k = 0; k < 12; ++k) {
      const double middle = (lo + hi) / 2;
      ((value(middle) > 0) == rising ? hi : lo) = middle;
    }
    zeros[count++] = (lo + hi) / 2;
  }
  return count;
}

/// Where a straight side p + v d passes eta.
template <class R>
void add_side(const Vec3<R>& p, const Vec3<R>& d, SingularPairs<R>& pairs) {
  using std::sqrt;
  const R square = d.dot(d);
  if (!(square > 0)) return;
  const Vec3<R> c = p.cross(d);
  pairs.add({R(-p.dot(d) / square), static_cast<double>(R(sqrt(c.dot(c)) / square))});
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

/// A lower bound of the ellipse about [0, 1] that singularities in v lie outside of: for every u in [0, 1] the zeros of
/// r^2 along the straight line v -> xi(u, v) lie on the one whose axis is the distances of both ends over its length.
template <class R>
double ellipse_from_distance(const QuadFrame<R>& q) {
  const double step = std::sqrt(std::max(static_cast<double>(q.b.dot(q.b)), static_cast<double>(q.b1.dot(q.b1))));
  const double ends = distance_of_segment(q.a, q.e) + distance_of_segment(Vec3<R>(q.a + q.b), Vec3<R>(q.e + q.w));
  if (!(ends < 1e6 * step)) return 1e6;
  const double axis = ends / step;
  return axis > 1 ? axis + std::sqrt(axis * axis - 1) : 1;
}

/// The singularities that the integral along line v may have: where the two sides across the lines pass eta, and where
/// a line does, unless that is beyond its ends, where the sides' own are the true ones.
template <class R>
SingularPairs<R> singular_pairs(const QuadFrame<R>& q) {
  SingularPairs<R> pairs;
  detail::add_side(q.a, q.b, pairs);
  detail::add_side(q.a1, q.b1, pairs);
  const auto keep = [&](const SingularPair<R>& pair) {
    const Vec3<R> a = q.start(pair.centre), e = q.direction(pair.centre);
    const double foot = -static_cast<double>(a.dot(e)) / static_cast<double>(e.dot(e));
    // The foot's real part, to first order in the width. On the axis a pair beyond the ends would be a singularity that
    // is not there.
    const double margin = std::min(0.3, 4 * pair.width);
    if (std::isfinite(pair.width) && foot >= -margin && foot <= 1 + margin) pairs.add(pair);
  };
  const auto p = LineArea<R>(q, R(0)).polynomial();
  const double size = p[0] + std::abs(p[2]) + p[4];
  if (!(size > 0)) return pairs;
  // Next to the real axis roots are found from the real minima, which stay accurate however close the pair is.
  std::array<double, 3> turns;
  const int count = detail::zeros_within({p[1], 2 * p[2], 3 * p[3], 4 * p[4]}, turns);
  const auto bend = [&](double v) { return 2 * p[2] + v * (6 * p[3] + v * 12 * p[4]); };
  R centre(0.5);
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    const double v = turns[i], value = p[0] + v * (p[1] + v * (p[2] + v * (p[3] + v * p[4])));
    if (!(bend(v) > 0) || !(value / bend(v) < lowest)) continue;
    lowest = value / bend(v);
    centre = R(v);
  }
  std::array<double, 5> local;
  const double depth = detail::settle(q, centre, local);
  const auto add_pair = [&](double r, double t) {
    keep({R(centre - R(r / 2)), std::sqrt(std::max(0.0, t - r * r / 4))});
  };
  if (p[4] < 1e-26 * size) {
    if (local[2] > 0) add_pair(local[1] / local[2], local[0] / local[2]);
    return pairs;
  }
  const detail::Factors f =
      local[0] == 0 ? detail::Factors{0, 0, local[4], local[3], local[2]} : detail::factors_of(local, depth * depth);
  add_pair(f.r, f.t);
  // The other pair; one that is on the axis but for rounding is looked for about its own minimum, which a third root
  // next to it would displace.
  const double r = f.linear / f.lead, t = f.constant / f.lead;
  if (!(t < 900)) return pairs;
  if (t - r * r / 4 > 1e-7) {
    add_pair(r, t);
    return pairs;
  }
  centre -= R(r / 2);
  const double own = detail::settle(q, centre, local);
  add_pair(0, own * own);
  return pairs;
}

}  // namespace cageproof::adaptive_qmvc
