// SPDX-License-Identifier: MIT
// Integrals of t^j / r^(2m + 1) along one straight line of a bilinear quad: one logarithm, in forms whose terms do not
// cancel.
#pragma once

#include "quad/engine/line_moments.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <map>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// A Gauss-Legendre rule on (0, 1).
template <class R>
struct Nodes {
  std::span<const R> nodes, weights;
};

/// gauss_rule, for long double too: its range holds powers of distances that a double's does not. In 800 digits three
/// points only.
template <class R>
Nodes<R> nodes_of(int n) {
  if constexpr (std::same_as<R, long double>) {
    struct Rule {
      std::vector<long double> nodes, weights;
    };
    thread_local std::map<int, Rule> rules;
    const auto [at, added] = rules.try_emplace(n);
    if (added) {
      const GaussLegendre<Mp50>& wide = gauss_rule<Mp50>(n);
      for (const Mp50& x : wide.nodes) at->second.nodes.push_back(static_cast<long double>(x));
      for (const Mp50& x : wide.weights) at->second.weights.push_back(static_cast<long double>(x));
    }
    return {at->second.nodes, at->second.weights};
  } else if constexpr (std::same_as<R, Mp800>) {
    static const R half = R(1) / 2, off = sqrt(R(R(3) / 20));
    static const std::array<R, 3> nodes{R(half - off), half, R(half + off)},
        weights{R(R(5) / 18), R(R(4) / 9), R(R(5) / 18)};
    return {nodes, weights};
  } else {
    const GaussLegendre<R>& rule = gauss_rule<R>(n);
    return {rule.nodes, rule.weights};
  }
}

/// The largest m, and the powers of t that any integrand asks for.
inline constexpr int kTopPower = 4, kPowers = kTopPower + 3;

/// How many powers of t the integrals of r^-(2m + 1) have.
constexpr int powers_of(int m) { return m < 0 ? 2 : m == 2 || m == 3 ? m + 4 : m + 3; }

/// power[m + 1][j]: the integral of t^j r^-(2m + 1) dt over a line a + (origin + t) e of parameter length 1, for
/// m = -1 .. top and j < powers_of(m).
template <class R>
struct LinePowers {
  R origin;
  std::array<std::array<R, kPowers>, kTopPower + 2> power;
};

/// The integrals about the foot of the perpendicular, for R^2 = t^2 + k2, t from t0 to t1 = t0 + 1: those of `power`,
/// without the line's length. k2 may be zero where the foot is beyond the ends.
template <class R>
void powers_about_foot(const R& t0, const R& t1, const R& k2, int top, LinePowers<R>& result) {
  using std::abs, std::log, std::log1p, std::sqrt;
  auto& power = result.power;
  const R r0 = sqrt(R(t0 * t0 + k2)), r1 = sqrt(R(t1 * t1 + k2));
  const R p0 = 1 / r0, p1 = 1 / r1, w0 = t0 * p0, w1 = t1 * p1;
  const R dr = (t0 + t1) / (r0 + r1);  // r1 - r0
  R length, cube;                      // the integrals of 1/R and of 1/R^3
  if (t0 < R(0) && t1 > R(0)) {
    length = log(R((r1 + t1) * (r0 - t0) / k2));
    cube = (w1 - w0) / k2;
  } else {
    const bool first = abs(t0) < abs(t1);
    length = log1p(R((1 + abs(dr)) / (first ? R(r0 + abs(t0)) : R(r1 + abs(t1)))));
    cube = (t0 + t1) * p0 * p1 / (t1 * r0 + t0 * r1);
  }
  const R ends = t1 * r1 - t0 * r0;
  power[0][0] = (ends + k2 * length) / 2;
  power[0][1] = dr * (r0 * r0 + r0 * r1 + r1 * r1) / 3;
  power[1][0] = length;
  power[1][1] = dr;
  power[1][2] = (ends - k2 * length) / 2;
  if (top < 1) return;
  const R both = p0 * p1, dp = dr * both;  // 1/r0 - 1/r1
  const R rest = length - k2 * cube;
  const R s0 = t0 * t0, s1 = t1 * t1;
  power[2][0] = cube;
  power[2][1] = dp;
  power[2][2] = rest;
  power[2][3] = dr * (s0 * s1 + k2 * (s0 + s1)) * both * both / (1 + k2 * both);
  if (top < 2) return;
  // dt/R^3 = dw/k2 in w = t/R, and t dt/R^3 = -d(1/R): polynomials, whose terms are positive, of degree 6 at most.
  const Nodes<R> gauss = nodes_of<R>(top < 4 ? 3 : 4);
  const R i0 = p0 * p0, i1 = p1 * p1, q = k2 * cube * cube, d = k2 * dp * dp;
  for (int m = 2; m <= top; ++m)
    for (int j = 0; j <= m + 2; ++j) power[m + 1][j] = R(0);
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const R& s = gauss.nodes[i];
    const R y = 1 - s, b = s * y;
    const R w = w0 * y + w1 * s, p = p0 * y + p1 * s;
    const R inverse = i0 * y + i1 * s + q * b, square = w0 * w0 * y + w1 * w1 * s + d * b;
    const R even = cube * gauss.weights[i], odd = dp * gauss.weights[i];
    std::array<R, kPowers> ws, inverses, ps, squares;
    ws[0] = inverses[0] = ps[0] = squares[0] = R(1);
    for (int k = 1; k <= 2 * top - 2; ++k) {
      ws[k] = ws[k - 1] * w;
      ps[k] = ps[k - 1] * p;
    }
    for (int k = 1; k < top; ++k) {
      inverses[k] = inverses[k - 1] * inverse;
      squares[k] = squares[k - 1] * square;
    }
    for (int m = 2; m <= top; ++m)
      for (int j = 0; j <= m + 2; ++j) {
        if (m == 2 && j == 4) continue;
        if (j % 2 == 0) power[m + 1][j] += even * ws[j] * inverses[m - 1 - j / 2];
        else power[m + 1][j] += odd * squares[(j - 1) / 2] * ps[2 * m - 1 - j];
      }
  }
  power[3][4] = rest - k2 * cube * (w0 * w0 + w0 * w1 + w1 * w1) / 3;
  power[3][5] = power[2][3] - k2 * power[3][3];
  if (top > 2) power[4][6] = power[3][4] - k2 * power[4][4];
}

/// The integrals of the line a + t e, t in [first, first + 1].
/// \param area |a x e|^2
template <class R>
void line_powers_about_foot(const Vec3<R>& a, const Vec3<R>& e, const R& first, const R& last, const R& area, int top,
                            LinePowers<R>& result) {
  using std::sqrt;
  const R length2 = e.dot(e);
  const R inverse = 1 / length2;
  const R to_foot = a.dot(e) * inverse;
  result.origin = -to_foot;
  powers_about_foot<R>(first + to_foot, last + to_foot, area * inverse * inverse, top, result);
  const R root = sqrt(length2);
  R scale = root;
  for (int m = -1; m <= top; ++m) {
    for (int j = 0; j < powers_of(m); ++j) result.power[m + 1][j] *= scale;
    scale = m < 0 ? R(1 / root) : R(scale * inverse);
  }
}

/// The same by Gauss-Legendre about the line's middle, for lines whose ends are far away in sum. The length may be
/// zero.
template <class R>
void line_powers_by_gauss(const Vec3<R>& a, const Vec3<R>& e, const R& first, const Nodes<R>& rule, int top,
                          LinePowers<R>& result) {
  using std::sqrt;
  const R half = R(1) / 2;
  result.origin = first + half;
  const Vec3<R> middle = a + result.origin * e;
  const R c = middle.dot(middle), b = 2 * middle.dot(e), l = e.dot(e);
  for (int m = -1; m <= top; ++m)
    for (int j = 0; j < powers_of(m); ++j) result.power[m + 1][j] = R(0);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const R s = rule.nodes[i] - half;
    const R r2 = c + s * (b + s * l);
    const R inverse = 1 / r2;
    R f = rule.weights[i] * sqrt(r2);
    for (int m = -1; m <= top; ++m) {
      R term = f;
      for (int j = 0; j < powers_of(m); ++j, term *= s) result.power[m + 1][j] += term;
      f *= inverse;
    }
  }
}

}  // namespace cageproof::adaptive_qmvc
