// SPDX-License-Identifier: MIT
// Integrals along a segment of even powers of the distance, times its logarithm, which polyharmonic layers are made of.
#pragma once

#include "cageproof/closed_form/segment/engine/far_sums.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"

#include <vector>

namespace cageproof::closed_form::segment {

/// g(r) = r^(2 power) (log ln r + plain).
template <Scalar R>
struct Radial {
  int power;
  R log, plain;

  /// g'/r, of which gradients and Hessians are made: grad g = x g'/r.
  Radial next() const { return {power - 1, 2 * power * log, 2 * power * plain + log}; }
};

/// G_s times 2 pi, the Green function of the s-th power of the Laplacian ([W12] Appendix B, exponent and b_i after the
/// errata): r^(2(s - 1)) (a_s ln r - b_s). \param order s, from 1 on
template <Scalar R>
Radial<R> polyharmonic_green_function(int order) {
  Radial<R> g{order - 1, R(1), R(0)};
  for (int i = 1; i < order; ++i) {
    g.plain = (g.plain - g.log / R(i)) / R(4 * i * i);
    g.log /= R(4 * i * i);
  }
  return g;
}

/// h^k int s^i g(r) ds over the segment, in units of the frame but for the logarithm, which is that of the distance
/// itself: s the arc length from the nearest point of the line, r^2 = s^2 + h^2. Nearby from
///   (q + 1) int s^q (a ln r + b) = [s^(q+1) (a ln r + b - a/(q + 1))] + a h^2 E_q,
///   E_q = int s^q/r^2,  E_(q+2) = int s^q - h^2 E_q,
/// which begin with E_1 = ln(r1/r0) and h E_0, the angle; far away, where these cancel, from Gauss points. a ln r and b
/// may cancel, and do so in one number, before anything is multiplied with it.
template <Scalar R>
class RadialMoments {
 public:
  static constexpr int kMost = 12;
  /// \param most the largest power of s asked for, with those of g: below kMost
  RadialMoments(const Frame<R>& f, int most) : f_(f), unit_(unit_logarithm(f)) {
    if (f.is_for_sums()) set_far(most);
    else set_near(most);
  }

  /// \pre g.power >= 0, or g.power = -1, g.log = 0 and i + k >= 2
  R integral(int i, const Radial<R>& g, int k) const {
    return nodes_.empty() ? near(i, g, k) : far(g, [&](const Node& n) { return power(n.s, i); }) * power(f_.h, k);
  }
  /// The same with the hat function of an end before s^i.
  R integral_of_hat(int end, int i, const Radial<R>& g, int k) const {
    if (!nodes_.empty()) return far(g, [&](const Node& n) { return n.hat[end] * power(n.s, i); }) * power(f_.h, k);
    const R difference = f_.s[1 - end] * near(i, g, k) - near(i + 1, g, k);
    return (end == 0 ? difference : R(-difference)) / f_.length;
  }

 private:
  struct Node {
    R s, weight, square, logarithm;
    std::array<R, 2> hat;
  };

  static R power(const R& x, int n) {
    R p = 1;
    for (int i = 0; i < n; ++i) p *= x;
    return p;
  }

  void set_far(int most) {
    using std::log;
    // Every factor s^2 takes a degree of those that the rule is exact for.
    const auto& [nodes, weights] = gauss_legendre<R>(far_points(f_) + (most + 1) / 2);
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R s = f_.s[0] + f_.length * nodes[j], square = s * s + f_.h * f_.h;
      nodes_.push_back({s, weights[j] * f_.length, square, log(square) / 2 + unit_, {1 - nodes[j], nodes[j]}});
    }
  }

  void set_near(int most) {
    ratios_[0] = f_.angle;  // h E_0
    ratios_[1] = f_.log_ratio;
    std::array<R, 2> s{R(1), R(1)};
    for (int q = 0; q <= most; ++q) {
      for (int end = 0; end < 2; ++end) s[end] *= f_.s[end];
      powers_[q] = s;
      differences_[q] = difference(q + 1);
      ratios_[q + 2] = differences_[q] / R(q + 1) - lifted(q);
    }
    for (int end = 0; end < 2; ++end) logarithms_[end] = f_.log_r[end] + unit_;
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

  // [s^(q+1) (a ln r + b)], b with what the recurrence takes from it.
  R between_ends(int q, const R& a, const R& b) const {
    if (q % 2 != 0 && f_.are_alike()) {
      const R mean = a * (logarithms_[0] + logarithms_[1]) / R(2) + b;
      return differences_[q] * mean + (powers_[q][0] + powers_[q][1]) * a * f_.log_ratio / R(2);
    }
    std::array<R, 2> at;
    for (int end = 0; end < 2; ++end)
      at[end] = f_.at_end && end == f_.near_end ? R(0) : R(powers_[q][end] * (a * logarithms_[end] + b));
    return at[1] - at[0];
  }

  R near(int i, const Radial<R>& g, int k) const {
    if (g.power < 0) {
      if (f_.at_end && i <= 1) return R(0);
      return g.plain * (i == 0 ? power(f_.h, k - 1) : power(f_.h, k)) * ratios_[i];
    }
    R sum = 0, binomial = 1;
    for (int j = 0; j <= g.power; ++j) {
      const int q = 2 * j + i;
      const R moment = between_ends(q, g.log, R(g.plain - g.log / R(q + 1))) + g.log * lifted(q);
      sum += binomial * power(f_.h, 2 * (g.power - j)) * moment / R(q + 1);
      binomial = binomial * R(g.power - j) / R(j + 1);
    }
    return power(f_.h, k) * sum;
  }

  template <class Factor>
  R far(const Radial<R>& g, const Factor& factor) const {
    R sum = 0;
    for (const Node& n : nodes_) {
      const R radial = g.power < 0 ? R(1 / n.square) : power(n.square, g.power);
      sum += n.weight * factor(n) * radial * (g.log * n.logarithm + g.plain);
    }
    return sum;
  }

  const Frame<R>& f_;
  R unit_;
  std::vector<Node> nodes_;  // far away
  // Nearby, of s^(q+1): at the ends, and the difference; E_q; and the logarithms of the ends' distances.
  std::array<std::array<R, 2>, kMost> powers_;
  std::array<R, kMost> differences_;
  std::array<R, kMost + 2> ratios_;
  std::array<R, 2> logarithms_;
};

}  // namespace cageproof::closed_form::segment
