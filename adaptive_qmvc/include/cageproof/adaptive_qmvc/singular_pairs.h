// SPDX-License-Identifier: MIT
// Where the integral along the lines of a bilinear quad is singular, as a function of the line.
#pragma once

#include "cageproof/adaptive_qmvc/local_quad.h"
#include "cageproof/adaptive_qmvc/outer_rule.h"

#include <complex>
#include <vector>

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

inline Derivatives at(const std::array<double, 5>& p, Complex z) {
  Derivatives d{p[4], 0, 0};
  for (int k = 3; k >= 0; --k) {
    d.ddf = d.ddf * z + d.df;
    d.df = d.df * z + d.f;
    d.f = d.f * z + p[k];
  }
  d.ddf *= 2;
  return d;
}

/// A root of a quartic by Laguerre's iteration.
inline Complex root_of(const std::array<double, 5>& p, Complex z) {
  for (int i = 0; i < 40; ++i) {
    const auto [f, df, ddf] = at(p, z);
    if (f == 0.0) break;
    const Complex g = df / f, h = g * g - ddf / f;
    const Complex root = std::sqrt(3.0 * (4.0 * h - g * g));
    const Complex below = std::abs(g + root) > std::abs(g - root) ? g + root : g - root;
    if (below == 0.0) break;
    const Complex step = 4.0 / below;
    z -= step;
    if (std::abs(step) < 1e-9 * std::abs(z)) break;
  }
  return z;
}

/// The root next to `guess` of |a x e|^2, refined about its own real part, where nothing cancels.
template <class R>
SingularPair<R> refined(const LocalQuad<R>& q, Complex guess) {
  R centre = R(guess.real());
  double width = std::abs(guess.imag());
  for (int round = 0; round < 3; ++round) {
    const auto p = LineArea<R>(q, centre).polynomial();
    Complex s{0, width};
    // The quadratic part decides unless another pair is close.
    if (p[2] > 0 && 4 * p[0] * p[2] > p[1] * p[1])
      s = Complex(-p[1], std::sqrt(4 * p[0] * p[2] - p[1] * p[1])) / (2 * p[2]);
    for (int i = 0; i < 4; ++i) {
      const auto [f, df, ddf] = at(p, s);
      if (df == 0.0 || !std::isfinite(std::abs(f / df)) || std::abs(f / df) > 0.5 * std::abs(s)) break;
      s -= f / df;
    }
    centre += R(s.real());
    width = std::abs(s.imag());
    if (std::abs(s.real()) < 0.1 * width) break;
  }
  return {centre, width};
}

/// Where a straight side p + v d passes eta.
template <class R>
void add_side(const Vec3<R>& p, const Vec3<R>& d, std::vector<SingularPair<R>>& pairs) {
  using std::sqrt;
  const R square = d.dot(d);
  if (!(square > 0)) return;
  const Vec3<R> c = p.cross(d);
  pairs.push_back({R(-p.dot(d) / square), static_cast<double>(R(sqrt(c.dot(c)) / square))});
}

}  // namespace detail

/// The singularities that the integral along line v may have: where the two sides across the lines pass eta, and where a line does, unless that is
/// beyond its ends, where the sides' own are the true ones.
template <class R>
std::vector<SingularPair<R>> singular_pairs(const LocalQuad<R>& q) {
  std::vector<SingularPair<R>> pairs;
  pairs.reserve(4);
  detail::add_side(q.a, q.b, pairs);
  detail::add_side(q.a1, q.b1, pairs);
  const auto keep = [&](detail::Complex guess) {
    if (!(std::abs(guess) < 30)) return;
    const SingularPair<R> pair = detail::refined(q, guess);
    const Vec3<R> a = q.start(pair.centre), e = q.direction(pair.centre);
    const R square = e.dot(e);
    if (!std::isfinite(pair.width)) return;
    const double foot = static_cast<double>(R(-a.dot(e) / square));
    // The foot's real part, to first order in the width; margins cost nodes, not digits.
    if (foot > -0.3 && foot < 1.3) pairs.push_back(pair);
  };
  const auto p = LineArea<R>(q, R(0)).polynomial();
  const double size = p[0] + p[2] + p[4];
  if (!(size > 0)) return pairs;
  if (p[4] < 1e-26 * size) {
    if (p[2] > 1e-26 * size) keep(detail::Complex(-p[1], std::sqrt(std::max(0.0, 4 * p[0] * p[2] - p[1] * p[1]))) / (2 * p[2]));
    return pairs;
  }
  const detail::Complex z = detail::root_of(p, {0.4, 0.5});
  keep(z);
  // (s^2 + m s + n)(p4 s^2 + g s + h)
  const double m = -2 * z.real(), n = std::norm(z);
  const double g = p[3] - m * p[4], h = p[2] - n * p[4] - m * g;
  keep(detail::Complex(-g, std::sqrt(std::max(0.0, 4 * p[4] * h - g * g))) / (2 * p[4]));
  return pairs;
}

}  // namespace cageproof::adaptive_qmvc
