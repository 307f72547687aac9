// SPDX-License-Identifier: MIT
// The zeros of the quartic |a x e|^2 in the line: the factor that remains next to a known one, and all zeros, near or
// far.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

namespace cageproof::adaptive_qmvc::detail {

/// Coefficients, the constant first. F is double, or long double where squares of distances leave double's range.
template <class F>
using Quartic = std::array<F, 5>;
template <class F>
using Complex = std::complex<F>;

// Without the library's care for infinities, which costs more than the iterations.
template <class F>
Complex<F> product(Complex<F> a, Complex<F> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
template <class F>
Complex<F> quotient(Complex<F> a, Complex<F> b) {
  return product(a, std::conj(b)) / std::norm(b);
}

/// s^2 + r s + t, and what is left of a quartic: lead s^2 + linear s + constant.
template <class F>
struct Factors {
  F r, t, lead, linear, constant;
};

/// The real quadratic factors of a quartic next to s^2 + t, by Bairstow's iteration; nothing where it does not settle.
template <class F>
std::optional<Factors<F>> factors_of(const Quartic<F>& p, F t) {
  F r = 0;
  for (int i = 0; i < 12; ++i) {
    const F b4 = p[4], b3 = p[3] - r * b4, b2 = p[2] - r * b3 - t * b4, b1 = p[1] - r * b2 - t * b3,
            b0 = p[0] - r * b1 - t * b2;
    const F c3 = b3 - r * b4, c2 = b2 - r * c3 - t * b4, c1 = b1 - r * c2 - t * c3;
    const F inverse = 1 / (c2 * c2 - c1 * c3);
    const F dr = (b1 * c2 - b0 * c3) * inverse, dt = (b0 * c2 - b1 * c1) * inverse;
    r += dr;
    t += dt;
    if (!std::isfinite(r + t)) break;
    if (dr * dr < 1e-10 * std::abs(t) && std::abs(dt) < 1e-5 * std::abs(t)) {
      const F linear = p[3] - r * p[4];
      return Factors<F>{r, t, p[4], linear, p[2] - r * linear - t * p[4]};
    }
  }
  return std::nullopt;
}

/// All zeros of a quartic by Aberth's iteration, which starts from the radii that the upper hull of log |c_k| gives: it
/// finds zeros of very different size, each to the digits that its own size allows. Fewer where leading coefficients
/// are zero.
template <class F>
struct QuarticZeros {
  std::array<Complex<F>, 4> zero;
  int count = 0;
};

template <class F>
QuarticZeros<F> zeros_of(const Quartic<F>& c) {
  QuarticZeros<F> z;
  int degree = 4, low = 0;
  while (degree > 0 && !(std::abs(c[degree]) > 0)) --degree;
  while (low < degree && c[low] == 0) ++low;
  z.count = low;  // zeros at 0
  std::fill_n(z.zero.begin(), low, Complex<F>(0));
  for (int i = low; i < degree;) {
    int next = i + 1;
    F log_radius = 1e300;
    for (int j = i + 1; j <= degree; ++j) {
      if (c[j] == 0) continue;
      const F radius = (std::log(std::abs(c[i])) - std::log(std::abs(c[j]))) / (j - i);
      if (radius > log_radius) continue;
      log_radius = radius;
      next = j;
    }
    // Away from the axis and from symmetry.
    for (int k = i; k < next; ++k)
      z.zero[z.count++] = std::polar(std::exp(log_radius), F(0.7 + 1.5 * (k - i) + 0.3 * i));
    i = next;
  }
  for (int step = 0; step < 60; ++step) {
    F change = 0;
    for (int i = low; i < z.count; ++i) {
      const Complex<F> x = z.zero[i];
      Complex<F> f = c[degree], df = 0;
      for (int k = degree - 1; k >= low; --k) {
        df = product(df, x) + f;
        f = product(f, x) + c[k];
      }
      if (f == F(0)) continue;
      Complex<F> slope = quotient(df, f);
      for (int j = low; j < z.count; ++j)
        if (j != i) slope -= quotient(Complex<F>(1), x - z.zero[j]);
      const Complex<F> move = quotient(Complex<F>(1), slope);
      if (!std::isfinite(move.real() + move.imag())) continue;
      z.zero[i] -= move;
      change = std::max(change, std::norm(move) / std::norm(z.zero[i]));
    }
    if (change < 1e-20) break;
  }
  return z;
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

}  // namespace cageproof::adaptive_qmvc::detail
