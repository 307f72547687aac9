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
///   int s^q ln r = ([s^(q+1) ln r] - E_(q+2))/(q + 1),  E_q = int s^q/r^2,  E_(q+2) = int s^q - h^2 E_q,
/// which begin with E_1 = ln(r1/r0) and h E_0, the angle; far away, where these cancel, from Gauss points.
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
    const R square = f_.h * f_.h;
    ratios_[0] = f_.angle;  // h E_0
    ratios_[1] = f_.log_ratio;
    std::array<R, 2> s{R(1), R(1)};
    for (int q = 0; q <= most; ++q) {
      std::array<R, 2> at_ends;
      for (int end = 0; end < 2; ++end) {
        s[end] *= f_.s[end];
        at_ends[end] = f_.at_end && end == f_.near_end ? R(0) : R(s[end] * f_.log_r[end]);
      }
      powers_[q] = (s[1] - s[0]) / R(q + 1);
      const R below = q == 0 ? R(f_.h * f_.angle) : f_.at_end && q == 1 ? R(0) : R(square * ratios_[q]);
      ratios_[q + 2] = powers_[q] - below;
      logarithms_[q] = (at_ends[1] - at_ends[0] - ratios_[q + 2]) / R(q + 1);
    }
  }

  R near(int i, const Radial<R>& g, int k) const {
    if (g.power < 0) {
      if (f_.at_end && i <= 1) return R(0);
      return g.plain * (i == 0 ? power(f_.h, k - 1) : power(f_.h, k)) * ratios_[i];
    }
    R sum = 0, binomial = 1;
    for (int j = 0; j <= g.power; ++j) {
      const int q = 2 * j + i;
      sum +=
          binomial * power(f_.h, 2 * (g.power - j)) * (g.log * logarithms_[q] + (g.plain + g.log * unit_) * powers_[q]);
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
  std::vector<Node> nodes_;                   // far away
  std::array<R, kMost> powers_, logarithms_;  // nearby: int s^q, int s^q ln r
  std::array<R, kMost + 2> ratios_;           // nearby: E_q
};

}  // namespace cageproof::closed_form::segment
