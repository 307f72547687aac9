// SPDX-License-Identifier: MIT
// Integrals along a segment of even powers of the distance, times its logarithm, which polyharmonic layers are made of.
#pragma once

#include "cageproof/closed_form/segment/engine/logarithms.h"

namespace cageproof::closed_form::segment {

/// g(r) = r^(2 power) (log ln r + plain).
template <Scalar R>
struct Radial {
  int power;
  R log, plain;
  long double zero;  ///< -plain/log: the logarithm of the distance at which it vanishes

  /// g'/r, of which gradients and Hessians are made: grad g = x g'/r.
  Radial next() const {
    return {power - 1, R(2 * power) * log, R(2 * power) * plain + log, power == 0 ? zero : zero - 0.5L / power};
  }
};

/// G_s times 2 pi, the Green function of the s-th power of the Laplacian ([W12] Appendix B, exponent and b_i after the
/// errata): r^(2(s - 1)) (a_s ln r - b_s). \param order s, from 1 on
template <Scalar R>
Radial<R> polyharmonic_green_function(int order) {
  Radial<R> g{order - 1, R(1), R(0), 0};
  for (int i = 1; i < order; ++i) {
    g.zero += 1.0L / i;
    g.plain = (g.plain - g.log / R(i)) / R(4 * i * i);
    g.log /= R(4 * i * i);
  }
  return g;
}

template <Scalar R>
R power(const R& x, int n) {
  R p = 1;
  for (int i = 0; i < n; ++i) p *= x;
  return p;
}

/// e^x 2^shift, to a rounding of double.
template <Scalar R>
R scaled_exponential(long double x, int shift) {
  const auto value = static_cast<double>(std::ldexp(std::exp(x), shift));
  if constexpr (is_tracked<R>) return R::rounded(value, 0);
  else return R(value);
}

/// h^k int s^i g(r) ds over the segment, in units of the frame; only the logarithm is that of the distance itself. s is
/// the arc length from the nearest point of the line, r^2 = s^2 + h^2. The moments follow from
///   (q + 1) int s^q (a ln r + b) = [s^(q+1) (a ln r + b - a/(q + 1))] + a h^2 E_q,
///   E_q = int s^q/r^2,  E_(q+2) = int s^q - h^2 E_q,
/// which begin with E_1 = ln(r1/r0) and h E_0, the angle. a ln r and b may cancel, where the distance is
/// e^(-b/a): a ln r + b is a times the logarithm of their ratio.
template <Scalar R>
class RadialMoments {
 public:
  static constexpr int kMost = 12;
  /// \param most the largest power of s asked for, with those of g: below kMost
  RadialMoments(const Frame<R>& f, int most) : f_(f), unit_(unit_logarithm(f)) { set(most); }

  /// \pre g.power >= 0, or g.power = -1, g.log = 0 and i + k >= 2
  R integral(int i, const Radial<R>& g, int k) const {
    if (g.power < 0) {
      if (f_.at_end && i <= 1) return R(0);
      return g.plain * (i == 0 ? power(f_.h, k - 1) : power(f_.h, k)) * ratios_[i];
    }
    R sum = 0, binomial = 1;
    for (int j = 0; j <= g.power; ++j) {
      const int q = 2 * j + i;
      sum += binomial * power(f_.h, 2 * (g.power - j)) * (between_ends(q, g) + lifted(q)) / R(q + 1);
      binomial = binomial * R(g.power - j) / R(j + 1);
    }
    return g.log * power(f_.h, k) * sum;
  }
  /// integral(i, g, k) with the hat function of an end as a factor.
  R integral_of_hat(int end, int i, const Radial<R>& g, int k) const {
    const R difference = f_.s[1 - end] * integral(i, g, k) - integral(i + 1, g, k);
    return (end == 0 ? difference : R(-difference)) / f_.length;
  }

 private:
  void set(int most) {
    ratios_[0] = f_.angle;  // h E_0
    ratios_[1] = f_.log_ratio;
    std::array<R, 2> s{R(1), R(1)};
    for (int q = 0; q <= most; ++q) {
      for (int end = 0; end < 2; ++end) s[end] *= f_.s[end];
      powers_[q] = s;
      differences_[q] = difference(q + 1);
      ratios_[q + 2] = differences_[q] / R(q + 1) - lifted(q);
    }
  }

  // ln r - zero, of an end.
  R relative_logarithm(int end, const Radial<R>& g, int q) const {
    using std::log;
    if constexpr (!is_wide<R>) {
      constexpr int kComfortable = 60;  // beyond, r is far from where anything vanishes
      if (std::abs(f_.exponent) <= kComfortable)
        return log(R(f_.r[end] * scaled_exponential<R>(-(g.zero + 1.0L / (q + 1)), f_.exponent)));
    }
    return f_.log_r[end] + unit_ + (g.plain / g.log - R(1) / R(q + 1));
  }

  // h^2 E_q.
  R lifted(int q) const {
    if (q == 0) return f_.h * f_.angle;
    return f_.at_end && q == 1 ? R(0) : R(f_.h * f_.h * ratios_[q]);
  }

  // s1^n - s0^n, which over the middle is small for even n: length (s0 + s1) times a sum of even powers.
  R difference(int n) const {
    const R &s0 = f_.s[0], &s1 = f_.s[1];
    if (n % 2 != 0) return power(s1, n) - power(s0, n);
    R sum = 0;
    for (int i = 0; i < n; i += 2) sum += power(s1, i) * power(s0, n - 2 - i);
    return f_.length * f_.sum * sum;
  }

  // [s^(q+1) (ln r + b/a - 1/(q + 1))].
  R between_ends(int q, const Radial<R>& g) const {
    if (q % 2 != 0 && f_.are_alike()) {
      const R mean = (relative_logarithm(0, g, q) + relative_logarithm(1, g, q)) / R(2);
      return differences_[q] * mean + (powers_[q][0] + powers_[q][1]) * f_.log_ratio / R(2);
    }
    std::array<R, 2> at;
    for (int end = 0; end < 2; ++end)
      at[end] = f_.at_end && end == f_.near_end ? R(0) : R(powers_[q][end] * relative_logarithm(end, g, q));
    return at[1] - at[0];
  }

  const Frame<R>& f_;
  R unit_;
  // s^(q+1) at the ends, and the difference of both; and E_q.
  std::array<std::array<R, 2>, kMost> powers_;
  std::array<R, kMost> differences_;
  std::array<R, kMost + 2> ratios_;
};

template <Scalar R>
RadialMoments<R> radial_moments(const Frame<R>& f, int most) {
  return RadialMoments<R>(f, most);
}

}  // namespace cageproof::closed_form::segment
