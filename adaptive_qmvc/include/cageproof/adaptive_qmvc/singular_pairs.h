// SPDX-License-Identifier: MIT
// Where the integral along the lines of a bilinear quad is singular, as a function of the line.
#pragma once

#include "cageproof/adaptive_qmvc/local_quad.h"
#include "cageproof/adaptive_qmvc/outer_rule.h"

#include <complex>

namespace cageproof::adaptive_qmvc {

/// a(v) x e(v) about a line v: c0 + s c1 + s^2 c2, s the step from that line; zero (in complex s) where the line meets eta.
template <class R>
struct LineArea {
  Vec3<R> c0, c1, c2;

  LineArea(const LocalQuad<R>& q, const R& v) {
    const Vec3<R> a = q.start(v), e = q.direction(v);
    c0 = a.cross(e);
    c1 = q.b.cross(e) + a.cross(q.w);
    c2 = q.b.cross(q.w);
  }
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

/// The root of |a x e|^2 next to centre +- i width, refined; where it is close to the real axis, about the minimum there, where nothing cancels.
template <class R>
SingularPair<R> refined(const LocalQuad<R>& q, R centre, double width) {
  std::array<double, 5> p = LineArea<R>(q, centre).polynomial();
  for (int round = 0; round < 12 && p[2] > 0; ++round) {
    const double shift = -p[1] / (2 * p[2]), depth = std::sqrt(std::max(0.0, p[0] / p[2]));
    if (depth > 0.05 || std::abs(shift) > 0.2) break;
    width = depth;
    if (std::abs(shift) <= 1e-3 * depth || shift == 0) break;
    centre += R(shift);
    p = LineArea<R>(q, centre).polynomial();
  }
  if (p[0] == 0) return {centre, 0};
  // A real start would stay real.
  const Complex s = root_of(p, {0, width > 0 ? width : 0.1});
  return {R(centre + R(s.real())), std::abs(s.imag())};
}

/// Real zeros of c0 + c1 v + c2 v^2 + c3 v^3 within [-1, 2], by bisection between those of its derivatives: at most three.
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
    for (int k = 0; k < 60 && hi - lo > 1e-17; ++k) {
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

/// A lower bound of the ellipse about [0, 1] that singularities lie outside of, from the distance alone: r^2 = 0 at a complex line x + i y asks for
/// |y| to be the distance of eta from the surface at x, over |xi_v|.
template <class R>
double ellipse_from_distance(const LocalQuad<R>& q) {
  double reach = 0, step = 0;
  const Vec3<R> middle = q.a + (q.e + q.b + q.b1) / 4 + q.e / 4;
  const auto length = [](const Vec3<R>& x) { return std::sqrt(static_cast<double>(x.dot(x))); };
  for (const Vec3<R>& corner : {q.a, q.a1, Vec3<R>(q.a + q.b), Vec3<R>(q.a1 + q.b1)}) reach = std::max(reach, length(Vec3<R>(corner - middle)));
  step = std::max(length(q.b), length(q.b1));
  if (!(step > 0)) return 1e6;
  // Then |y| + |x - 1/2| >= h, and the least ellipse through such a point has the axis sqrt(2) h.
  const double axis = std::sqrt(2.0) * (length(middle) - reach) / step;
  return axis > 1 ? axis + std::sqrt(axis * axis - 1) : 1;
}

/// The singularities that the integral along line v may have: where the two sides across the lines pass eta, and where a line does, unless that is
/// beyond its ends, where the sides' own are the true ones.
template <class R>
SingularPairs<R> singular_pairs(const LocalQuad<R>& q) {
  SingularPairs<R> pairs;
  detail::add_side(q.a, q.b, pairs);
  detail::add_side(q.a1, q.b1, pairs);
  const auto keep = [&](const SingularPair<R>& pair) {
    const Vec3<R> a = q.start(pair.centre), e = q.direction(pair.centre);
    const double foot = -static_cast<double>(a.dot(e)) / static_cast<double>(e.dot(e));
    // The foot's real part, to first order in the width; margins cost nodes, not digits.
    if (std::isfinite(pair.width) && foot > -0.3 && foot < 1.3) pairs.add(pair);
  };
  const auto p = LineArea<R>(q, R(0)).polynomial();
  const double size = p[0] + std::abs(p[2]) + p[4];
  if (!(size > 0)) return pairs;
  // Next to the real axis roots are found from the real minima, which stay accurate however close the pair is.
  std::array<double, 3> turns;
  const int count = detail::zeros_within({p[1], 2 * p[2], 3 * p[3], 4 * p[4]}, turns);
  const auto bend = [&](double v) { return 2 * p[2] + v * (6 * p[3] + v * 12 * p[4]); };
  int minima = 0;
  detail::Complex last;
  for (int i = 0; i < count; ++i) {
    if (!(bend(turns[i]) > 0)) continue;
    const double value = p[0] + turns[i] * (p[1] + turns[i] * (p[2] + turns[i] * (p[3] + turns[i] * p[4])));
    const SingularPair<R> pair = detail::refined(q, R(turns[i]), std::sqrt(std::max(0.0, 2 * value / bend(turns[i]))));
    last = {static_cast<double>(pair.centre), pair.width};
    keep(pair);
    ++minima;
  }
  if (minima == 2 || p[4] < 1e-26 * size) return pairs;
  if (minima == 0) {
    const SingularPair<R> pair = detail::refined(q, R(0.5), 0.5);
    last = {static_cast<double>(pair.centre), pair.width};
    keep(pair);
  }
  // The other two: (s^2 + m s + n)(p4 s^2 + g s + h).
  const double m = -2 * last.real(), n = std::norm(last);
  const double g = p[3] - m * p[4], h = p[2] - n * p[4] - m * g;
  const detail::Complex other = detail::Complex(-g, std::sqrt(std::max(0.0, 4 * p[4] * h - g * g))) / (2 * p[4]);
  if (std::abs(other) < 30) keep(detail::refined(q, R(other.real()), std::abs(other.imag())));
  return pairs;
}

}  // namespace cageproof::adaptive_qmvc
