// SPDX-License-Identifier: MIT
// The edge form over even powers of the distance: the mean vector of [T18] Eq 13 and its derivatives.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/closed_form/triangle/engine/edge_integrals.h"

namespace cageproof::closed_form::triangle {

/// The decimal digits of multiprecision, tracked or not; 0 of other types.
template <class R>
inline constexpr int kDigits = 0;
template <unsigned D>
inline constexpr int kDigits<Mp<D>> = D;
template <unsigned D>
inline constexpr int kDigits<Tracked<Mp<D>>> = D;

/// The values of the integrals over one edge of even powers of r.
template <class R>
struct EvenIntegrals {
  R K2;             ///< r^-2: the edge's angle over its line's distance
  R K4, K6;         ///< r^-4, r^-6
  R in_plane_rest;  ///< h times the integral of 1/(r^2 rho^2), rho the distance to the point's projection

  EvenIntegrals(const FrameEdge<R>& e, const R& d) {
    using std::abs, std::atan2, std::sqrt;
    const R across = sqrt(e.D2);
    const R product = e.s0 * e.s1;
    K2 = across == R(0) ? R(e.length / product) : R(atan2(e.length * across, e.D2 + product) / across);
    // The difference of two angles is computed as one angle, `turn`, so that nothing is divided by a small number.
    const R beside = abs(e.h);
    const R angle = atan2(e.length * beside, beside * beside + product);
    const R step = d * d / (across + beside);
    const R turn = atan2(e.length * step * (beside * across - product),
                         (beside * beside + product) * (e.D2 + product) + e.length * e.length * beside * across);
    in_plane_rest = (angle * step + beside * turn) / (across * d * d);
    if (e.h < R(0)) in_plane_rest = -in_plane_rest;
    const R q0 = R(1) / (e.r0 * e.r0), q1 = R(1) / (e.r1 * e.r1);
    if (across == R(0)) {
      // On the line beyond the ends r is the arc length itself.
      K4 = abs(e.r1 * q1 * q1 - e.r0 * q0 * q0) / R(3);
      K6 = abs(e.r1 * q1 * q1 * q1 - e.r0 * q0 * q0 * q0) / R(5);
    } else {
      K4 = (e.s1 * q1 - e.s0 * q0 + K2) / (R(2) * e.D2);
      K6 = (e.s1 * q1 * q1 - e.s0 * q0 * q0 + R(3) * K4) / (R(4) * e.D2);
    }
    if constexpr (kDigits < R >> 0) set_beyond(e);
  }

 private:
  // Next to the line beyond the ends the quotients cancel, K6 by the fourth power of the distance. Series in powers of
  // -D2/s^2 replace them in multiprecision; in narrower types the running error asks for more digits.
  void set_beyond(const FrameEdge<R>& e) {
    using std::abs;
    const bool first = abs(e.s0) < abs(e.s1);
    const R nearest = first ? abs(e.s0) : abs(e.s1), farthest = first ? abs(e.s1) : abs(e.s0);
    constexpr int kDecades = 6;  // gained by each term
    if (!(e.s0 * e.s1 > R(0)) || !(e.D2 < R(std::pow(10., -kDecades)) * nearest * nearest)) return;
    K2 = K4 = K6 = R(0);
    const R a = R(1) / nearest, b = R(1) / farthest;
    R near_power = a, far_power = b;  // 1/s^(2k + 1)
    const auto next = [&] {
      R integral = near_power - far_power;
      near_power *= a * a;
      far_power *= b * b;
      return integral;
    };
    R first_part = next(), second_part = next() / R(3), third_part = next() / R(5), factor = R(1);
    for (int k = 0; k <= kDigits<R> / kDecades + 2; ++k) {
      K2 += factor * first_part;
      K4 += factor * R(k + 1) * second_part;
      K6 += factor * R((k + 1) * (k + 2) / 2) * third_part;
      first_part = second_part;
      second_part = third_part;
      third_part = next() / R(2 * k + 7);
      factor *= -e.D2;
    }
  }
};

/// w_t^k = int Gamma_k x.n/r^4 near the triangle, off it, up to degree N <= 2. With d the height, F = sum h K2 and G_k
/// = sum (nu.g_k) K2 over the edges, w_k = (d G_k - Gamma_k F/d)/2; in the triangle's plane, and next to it, w_k = d
/// (G_k + Gamma_k sum h K4)/2 to first order in d, the next being the third.
template <class R, int N>
class EvenForm {
 public:
  explicit EvenForm(const Frame<R>& frame);

  const Frame<R>& frame() const { return frame_; }
  /// \pre the point is not on the triangle
  std::array<Taylor<R, N>, 3> mean_value() const { return is_flat() ? in_plane() : off_plane(); }

 private:
  static constexpr int K = N >= 1 ? N - 1 : 0;

  // Whether in_plane() is to be used. off_plane() divides by d for each derivative; in_plane() leaves a relative
  // d/distance out of second derivatives, here below half of the digits, and no more digits are asked of this
  // arithmetic.
  bool is_flat() const {
    if (frame_.d == R(0)) return true;
    if constexpr (kDigits < R >> 0) {
      using std::abs;
      const auto& e = frame_.edges;
      const bool within = e[0].h >= R(0) && e[1].h >= R(0) && e[2].h >= R(0);
      return !within && abs(frame_.d) < R(std::pow(10., -kDigits<R> / 2 - 2)) * distance_of(frame_);
    } else {
      return false;
    }
  }
  std::array<Taylor<R, N>, 3> off_plane() const;
  std::array<Taylor<R, N>, 3> in_plane() const;
  // G = sum (nu.g) K2.
  Taylor<R, N> weighted(const Vec3<R>& g) const {
    Taylor<R, N> G;
    for (int i = 0; i < 3; ++i) {
      const Vec3<R>& nu = frame_.edges[i].nu;
      G.add(nu[0] * g[0] + nu[1] * g[1] + nu[2] * g[2], K2_[i]);
    }
    return G;
  }
  static Vec3<R> negative(const Vec3<R>& v) { return {-v[0], -v[1], -v[2]}; }

  // r1^p - r0^p as a polynomial, p = -2 or -4, its constant without cancellation.
  template <int D>
  Taylor<R, D> ends(int i, int p) const {
    const FrameEdge<R>& e = frame_.edges[i];
    const R q0 = R(1) / (e.r0 * e.r0), q1 = R(1) / (e.r1 * e.r1);
    Taylor<R, D> f;
    if constexpr (D >= 1) {
      f = distance_power<D>(frame_.p[(i + 1) % 3], p == -2 ? q1 : R(q1 * q1), e.r1, p);
      f.add(R(-1), distance_power<D>(frame_.p[i], p == -2 ? q0 : R(q0 * q0), e.r0, p));
    }
    f.c[0] = -e.length * (e.s0 + e.s1) * q0 * q1;
    if (p == -4) f.c[0] *= q0 + q1;
    return f;
  }

  const Frame<R>& frame_;
  std::array<Taylor<R, N>, 3> K2_;
  std::array<Taylor<R, K>, 3> K4_;
  R in_plane_rest_{};
};

template <class R, int N>
EvenForm<R, N>::EvenForm(const Frame<R>& frame) : frame_(frame) {
  for (int i = 0; i < 3; ++i) {
    const EvenIntegrals<R> even(frame.edges[i], frame.d);
    K4_[i].c[0] = even.K4;
    K2_[i].c[0] = even.K2;
    in_plane_rest_ += even.in_plane_rest;
    if constexpr (N >= 1) {
      if constexpr (N >= 2) {
        Taylor<R, 0> K6;
        K6.c[0] = even.K6;
        K4_[i] = edge_power<N - 1>(frame.edges[i], frame.n, frame.d, -4, even.K4, ends<N - 2>(i, -4), K6);
      }
      K2_[i] = edge_power<N>(frame.edges[i], frame.n, frame.d, -2, even.K2, ends<N - 1>(i, -2), K4_[i]);
    }
  }
}

template <class R, int N>
std::array<Taylor<R, N>, 3> EvenForm<R, N>::off_plane() const {
  Taylor<R, N> F;
  for (int i = 0; i < 3; ++i) F.add_linear(frame_.edges[i].h, negative(frame_.edges[i].nu), K2_[i]);
  // int 1/r^4 = F/(2 d^2), and `quotient` is F/d. Where the projection lies outside the triangle F vanishes with d^2,
  // so in_plane_rest gives the quotient.
  const auto& e = frame_.edges;
  const bool within = e[0].h >= R(0) && e[1].h >= R(0) && e[2].h >= R(0);
  Taylor<R, N> quotient;
  quotient.c[0] = within ? R(F.c[0] / frame_.d) : R(-frame_.d * in_plane_rest_);
  for (int k = 1; k <= N; ++k) {
    quotient.add_raised(k, negative(frame_.n), quotient);
    for (int m = Monomials<N>::first(k); m < Monomials<N>::first(k + 1); ++m) quotient.c[m] += F.c[m];
    quotient.divide_part(k, frame_.d);
  }
  std::array<Taylor<R, N>, 3> w;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = frame_.hat_gradient(k);
    w[k].add_linear(-frame_.hat(k), negative(g), quotient);
    w[k].add_linear(frame_.d, frame_.n, weighted(g));
    w[k] *= R(1) / R(2);
  }
  return w;
}

template <class R, int N>
std::array<Taylor<R, N>, 3> EvenForm<R, N>::in_plane() const {
  Taylor<R, K> heights;
  for (int i = 0; i < 3; ++i) heights.add_linear(frame_.edges[i].h, negative(frame_.edges[i].nu), K4_[i]);
  std::array<Taylor<R, N>, 3> w;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = frame_.hat_gradient(k);
    Taylor<R, K> y;
    y.add(R(1), weighted(g));
    y.add_linear(frame_.hat(k), g, heights);
    w[k].add_linear(frame_.d, frame_.n, y);
    w[k] *= R(1) / R(2);
  }
  return w;
}

}  // namespace cageproof::closed_form::triangle
