// SPDX-License-Identifier: MIT
// One edge's part of Kelvin's layers of a polygon, with derivatives, a vector of points at a time. Notation of
// plane_layers.h; p is direction_moment's:
//   2 pi mu K = (beta/4 length - (1 - beta/2) length M) Id + beta/4 Mat(p),  p = u^2 (length + 2 i h conj L).
//
// Next to a vertex F_k' has a part +-1/z there, and h u conj(1/z) is (z/conj z - u^2)/(2 i): the first sums to nothing
// with the next edge's, the second is constant. So derivatives are those of what is left of F_k without that part.
#pragma once

#include "plane_layers.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Mat(c) = (Re c, Im c; Im c, -Re c), and a multiple of the identity and of the turn n u' - u n', added to one
/// derivative of a matrix whose entries have `kept` of them.
inline void add_matrix(Lanes* to, int kept, Lanes round, Lanes spin, const Complex& c) {
  to[0] += round + c.re;
  to[kept] += c.im + spin;
  to[2 * kept] += c.im - spin;
  to[3 * kept] += round - c.re;
}

/// c e_i and c e_i e_j, where e_0 = 1 and e_1 = i: what derivatives of an analytic function are multiplied by.
inline Complex along(const Complex& c, int i) { return i == 0 ? c : Complex{-c.im, c.re}; }

/// The pairs of coordinates of second derivatives.
inline constexpr int kFirst[3] = {0, 0, 1}, kSecond[3] = {0, 1, 1};

/// An analytic function and its derivatives at the points, as far as they are asked for.
struct Analytic {
  Complex value, first, second;
};

/// Derivatives of h conj f, f analytic.
class TimesHeight {
 public:
  TimesHeight(const SideTable& side, Lanes height, const Analytic& f) : n_{side.u[1], -side.u[0]}, h_(height), f_(f) {}
  Complex slope(int i) const { return n_[i] * conjugate(f_.value) + h_ * conjugate(along(f_.first, i)); }
  Complex bend(int i, int j) const {
    return n_[i] * conjugate(along(f_.first, j)) + n_[j] * conjugate(along(f_.first, i)) +
           h_ * conjugate(along(along(f_.second, i), j));
  }

 private:
  double n_[2];
  Lanes h_;
  const Analytic& f_;
};

/// T: parts of the two ends.
template <int O>
void add_traction(const SeenEdgeOfPlane& edge, Mask afar, const Complex& over_middle, double beta,
                  const PlaneSums& sums) {
  const SideTable& side = edge.side;
  const SeenEnd* const end[2] = {&edge.a, &edge.b};
  const int vertex[2] = {side.from, side.to};
  const Lanes h = edge.seen.height;
  const Complex product = edge.a.over * edge.b.over, both = edge.a.over + edge.b.over;
  for (int k = 0; k < 2; ++k) {
    const Complex hat = edge.hat(k), slope = edge.hat_slope(k, afar, over_middle);
    const Complex lift = times(side.u, conjugate(slope));
    add_matrix(sums.at(0, 0, vertex[k], 4), 1, hat.im, (1 - beta) * hat.re, (-beta * h) * lift);
    if constexpr (O >= 1) {
      const Mask apart = end[k]->apart;
      const double sign = k == 0 ? -1 : 1;
      const Complex far = product * times(side.e, end[k]->over);
      Analytic f;  // F_k', without what sums to nothing
      f.value = select(apart, slope, sign * edge.seen.mean);
      f.first = select(apart, far, sign * product);
      if constexpr (O >= 2) f.second = select(apart, far * (end[k]->over + both), sign * (product * both));
      const TimesHeight lifted(side, h, f);
      Lanes* const gradient = sums.at(1, 0, vertex[k], 8);
      for (int i = 0; i < 2; ++i) {
        const Complex d = along(f.value, i);
        add_matrix(gradient + i, 2, d.im, (1 - beta) * d.re, -beta * times(side.u, lifted.slope(i)));
      }
      if constexpr (O >= 2) {
        Lanes* const hessian = sums.at(2, 0, vertex[k], 12);
        for (int at = 0; at < 3; ++at) {
          const int i = kFirst[at], j = kSecond[at];
          const Complex d = along(along(f.first, i), j);
          add_matrix(hessian + at, 3, d.im, (1 - beta) * d.re, -beta * times(side.u, lifted.bend(i, j)));
        }
      }
    }
  }
}

/// K of the edge.
template <int O>
void add_displacement(const SeenEdgeOfPlane& edge, Lanes mean_log, double beta, const PlaneSums& sums, int number) {
  const SideTable& side = edge.side;
  const double of_log = (1 - beta / 2) * side.length;
  add_matrix(sums.at(0, 1, number, 4), 1, (beta / 4 * side.length) - of_log * mean_log, Lanes{},
             (beta / 4) * direction_moment(edge));
  if constexpr (O >= 1) {
    Analytic f;  // L
    const Complex product = edge.a.over * edge.b.over;
    f.value = edge.seen.whole;
    f.first = times(side.e, product);
    if constexpr (O >= 2) f.second = f.first * (edge.a.over + edge.b.over);
    const TimesHeight lifted(side, edge.seen.height, f);
    // beta/4 times the derivative of p
    const auto moment = [&](const Complex& d) {
      return times(side.u, times(side.u, (beta / 2) * Complex{-d.im, d.re}));
    };
    Lanes* const gradient = sums.at(1, 1, number, 8);
    for (int i = 0; i < 2; ++i)
      add_matrix(gradient + i, 2, of_log * along(edge.seen.mean, i).re, Lanes{}, moment(lifted.slope(i)));
    if constexpr (O >= 2) {
      Lanes* const hessian = sums.at(2, 1, number, 12);
      for (int at = 0; at < 3; ++at) {
        const int i = kFirst[at], j = kSecond[at];
        add_matrix(hessian + at, 3, of_log * along(along(product, i), j).re, Lanes{}, moment(lifted.bend(i, j)));
      }
    }
  }
}

template <int O>
void add_kelvin(const SeenEdgeOfPlane& edge, Mask afar, const Complex& over_middle, Lanes mean_log, double beta,
                const PlaneSums& sums, int number) {
  add_traction<O>(edge, afar, over_middle, beta, sums);
  add_displacement<O>(edge, mean_log, beta, sums, number);
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
