// SPDX-License-Identifier: MIT
// Integrals over one edge of a triangle cage, in any arithmetic V. Functions of V (select, less, magnitude, root,
// log_of_quotient, angle_of) are declared before this header is read.
#pragma once

#include "edge_derivatives.h"
#include "edge_tails.h"
#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch {

/// The integrals over edges that the layers need for derivatives up to order O.
template <Layers L, int O>
struct Takes {
  static constexpr bool distances = L != Layers::Harmonic;
  static constexpr bool distance_gradients = L == Layers::Kelvin || (L == Layers::Biharmonic && O == 2);
  static constexpr bool inverse_gradients = O == 2 || (L == Layers::Kelvin && O == 1);
  /// The number of further derivatives, which Kelvin's layers need.
  static constexpr int further = O * static_cast<int>(L == Layers::Kelvin);
};

/// Integrals over one edge, in its table's direction u; D: from the point to the nearest point of the line.
template <class V, int Further = 0>
struct EdgeTerms;
template <class V>
struct EdgeTerms<V, 0> {
  V between;               ///< the scalar product of the vectors to the ends
  V inverse;               ///< L = int 1/r
  V distance;              ///< P = int r
  V sum, mean;             ///< r0 + r1, 2/(r0 + r1)
  V tail, bulge;           ///< L - length mean; P - length/mean
  V step;                  ///< r1 - r0
  V skew;                  ///< of short edges int t/r, t along u from the edge's middle
  V cubes;                 ///< K3 = int 1/r3
  V cubes_tail;            ///< of short edges K3 - length mean^3
  V cubes_skew;            ///< of short edges int t/r3
  Three<V> grad_inverse;   ///< grad L = S3 u + K3 D
  Three<V> grad_distance;  ///< grad P = -(r1 - r0) u - L D
  Three<V> turning;        ///< its part of grad omega: K3 D x u
};

template <class V>
struct EdgeTerms<V, 1> : EdgeTerms<V, 0> {
  Symmetric<V, 2> hess_distance;
};
template <class V>
struct EdgeTerms<V, 2> : EdgeTerms<V, 1> {
  Symmetric<V, 2> hess_inverse;
  Symmetric<V, 2> turning_slope;   ///< its part of Hess omega
  Symmetric<V, 3> third_distance;  ///< third derivatives of P
};

/// The terms, with zeros where the mask is set: all that is made of them is zero there.
template <class V, int Further, class M>
EdgeTerms<V, Further> without(M mask, const EdgeTerms<V, Further>& e) {
  EdgeTerms<V, Further> t;
  t.between = e.between;
  t.inverse = select(mask, V{}, e.inverse);
  t.distance = select(mask, V{}, e.distance);
  t.sum = select(mask, V{}, e.sum);
  t.mean = select(mask, V{}, e.mean);
  t.tail = select(mask, V{}, e.tail);
  t.bulge = select(mask, V{}, e.bulge);
  t.step = select(mask, V{}, e.step);
  t.skew = select(mask, V{}, e.skew);
  t.cubes = select(mask, V{}, e.cubes);
  t.cubes_tail = select(mask, V{}, e.cubes_tail);
  t.cubes_skew = select(mask, V{}, e.cubes_skew);
  for (int i = 0; i < 3; ++i) {
    t.grad_inverse[i] = select(mask, V{}, e.grad_inverse[i]);
    t.grad_distance[i] = select(mask, V{}, e.grad_distance[i]);
    t.turning[i] = select(mask, V{}, e.turning[i]);
  }
  if constexpr (Further >= 1)
    for (int i = 0; i < 6; ++i) t.hess_distance[i] = select(mask, V{}, e.hess_distance[i]);
  if constexpr (Further >= 2) {
    for (int i = 0; i < 6; ++i) {
      t.hess_inverse[i] = select(mask, V{}, e.hess_inverse[i]);
      t.turning_slope[i] = select(mask, V{}, e.turning_slope[i]);
    }
    for (int i = 0; i < 10; ++i) t.third_distance[i] = select(mask, V{}, e.third_distance[i]);
  }
  return t;
}

/// The table of integrals of the edge form in forms that do not cancel at any distance, as long as p0 x p1 does not.
/// \param p0, p1 from the point to the edge's ends \param r0, r1 their lengths
template <Layers L, int O, class V, class T>
EdgeTerms<V, Takes<L, O>::further> edge_terms(const EdgeTable<T>& e, const Three<V>& p0, const Three<V>& p1,
                                              const V& r0, const V& r1) {
  using Use = Takes<L, O>;
  EdgeTerms<V, Use::further> t;
  t.between = dot(p0, p1);
  const Three<V> normal = cross(p0, p1);  // length D x u
  const V square = dot(normal, normal);
  const V product = r0 * r1, sum = r0 + r1, reach = sum + e.length;
  // r0 r1 + p0 p1 where the point sees the edge under an acute angle; its quotient |p0 x p1|^2/(r0 r1 - p0 p1) where
  // that would cancel.
  const auto obtuse = less(t.between, V{} + 0.0);
  const V whole = product + magnitude(t.between);
  const V over = select(obtuse, square, whole), under = select(obtuse, whole, V(V{} + 1.0));
  const V length = V(V{} + e.length);
  const V over_sum = reciprocal(sum);
  t.sum = sum;
  t.mean = over_sum + over_sum;
  const auto logarithm = logarithm_of(V(reach * reach * under), V(over + over), length, sum, t.mean);
  t.inverse = logarithm.whole;
  t.tail = logarithm.tail;
  const V twice = dot(e.u, p0) * 2.0 + length;  // s0 + s1
  const V ratio = twice * over_sum;             // (r1 - r0)/length
  t.step = ratio * length;
  if constexpr (Use::distances || Use::inverse_gradients) {
    if constexpr (Use::distances) {
      const V line = square * e.over * e.over;
      t.distance = (line * t.inverse + (sum + twice * ratio) * e.length * 0.5) * 0.5;
      t.bulge = bulge_of(t.distance, length, sum, line, t.tail, t.mean, whole);
    }
    if constexpr (Use::distance_gradients || Use::inverse_gradients) {
      const V step = t.step;
      Three<V> foot;
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        foot[i] = (normal[k] * e.u[j] - normal[j] * e.u[k]) * e.over;
      }
      if constexpr (Use::distance_gradients && kReducesGradients<V>) t.skew = -0.5 * twice * t.tail;
      if constexpr (Use::distance_gradients)
        for (int i = 0; i < 3; ++i) t.grad_distance[i] = -(step * e.u[i] + t.inverse * foot[i]);
      if constexpr (Use::inverse_gradients) {
        const V over_product = (V{} + 1.0) / (product * over);
        const V cubes = sum * under * e.length * over_product;  // K3
        const V ends = step * over * over_product;              // S3
        const V turn = cubes * e.over;
        if constexpr (kReducesGradients<V>) {
          const V step2 = step * step, length2 = length * length, scaled = 0.125 * length * t.mean * over_product;
          t.cubes = cubes;
          t.cubes_tail = scaled * t.mean * t.mean * (4 * product * (length2 + step2) + step2 * step2);
          t.cubes_skew = -2 * scaled * twice * length2;
        }
        for (int i = 0; i < 3; ++i) {
          t.grad_inverse[i] = ends * e.u[i] + cubes * foot[i];
          t.turning[i] = turn * normal[i];
        }
        if constexpr (Use::further >= 1) {
          const V over_squares = (over * over_product) * (over * over_product);
          EdgeFrame<V> frame;
          for (int i = 0; i < 3; ++i) {
            frame.u[i] = V{} + e.u[i];
            frame.foot[i] = foot[i];
            frame.normal[i] = normal[i] * e.over;
          }
          frame.square = square * e.over * e.over;
          frame.inverse = t.inverse;
          frame.cubes = cubes;
          frame.ends = ends;
          t.hess_distance = hess_distance(frame);
          if constexpr (Use::further >= 2) {
            frame.fifths = cubes * ((r0 * r0 + r1 * r1) * over_squares * 1.5 + cubes * (cubes * frame.square) * 0.5);
            frame.fifth_ends = ends * (sum * sum - product) * over_squares;
            Three<V> grad_cubes;
            for (int i = 0; i < 3; ++i) grad_cubes[i] = frame.fifth_ends * frame.u[i] + frame.fifths * frame.foot[i];
            t.hess_inverse = hess_inverse(frame, grad_cubes);
            t.turning_slope = slope_of_turning(frame, grad_cubes);
            t.third_distance = third_distance(frame, t.grad_inverse);
          }
        }
      }
    }
  }
  return t;
}

}  // namespace cageproof::closed_form::batch
