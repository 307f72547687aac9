// SPDX-License-Identifier: MIT
// Integrals over one edge of a triangle cage, in any arithmetic V. Functions of V (select, less, magnitude, root,
// log_of_quotient, angle_of) are declared before this header is read.
#pragma once

#include "tables.h"

#include <array>

namespace cageproof::closed_form::batch {

/// A vector of the space.
template <class V>
struct Three {
  std::array<V, 3> c;
  V& operator[](int i) { return c.data()[i]; }
  const V& operator[](int i) const { return c.data()[i]; }
};

template <class V>
V dot(const Three<V>& a, const Three<V>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class V, class T>
V dot(const T (&constant)[3], const Three<V>& v) {
  return v[0] * constant[0] + v[1] * constant[1] + v[2] * constant[2];
}
template <class V>
Three<V> cross(const Three<V>& a, const Three<V>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Which integrals over edges the layers take for derivatives up to order O.
template <Layers L, int O>
struct Takes {
  static constexpr bool distances = L != Layers::Harmonic;
  static constexpr bool distance_gradients = L == Layers::Kelvin || (L == Layers::Biharmonic && O == 2);
  static constexpr bool inverse_gradients = O == 2;
};

/// Integrals over one edge, in its table's direction u; D: from the point to the nearest point of the line.
template <class V>
struct EdgeTerms {
  V between;               ///< the scalar product of the vectors to the ends
  V inverse;               ///< L = int 1/r
  V distance;              ///< P = int r
  Three<V> grad_inverse;   ///< grad L = S3 u + K3 D
  Three<V> grad_distance;  ///< grad P = -(r1 - r0) u - L D
  Three<V> turning;        ///< its part of grad omega: K3 D x u
};

/// The terms, with zeros where the mask is set: all that is made of them is zero there.
template <class V, class M>
EdgeTerms<V> without(M mask, const EdgeTerms<V>& e) {
  EdgeTerms<V> t;
  t.between = e.between;
  t.inverse = select(mask, V{}, e.inverse);
  t.distance = select(mask, V{}, e.distance);
  for (int i = 0; i < 3; ++i) {
    t.grad_inverse[i] = select(mask, V{}, e.grad_inverse[i]);
    t.grad_distance[i] = select(mask, V{}, e.grad_distance[i]);
    t.turning[i] = select(mask, V{}, e.turning[i]);
  }
  return t;
}

/// The table of integrals of the edge form in forms that do not cancel at any distance, as long as p0 x p1 does not.
/// \param p0, p1 from the point to the edge's ends \param r0, r1 their lengths
template <Layers L, int O, class V, class T>
EdgeTerms<V> edge_terms(const EdgeTable<T>& e, const Three<V>& p0, const Three<V>& p1, const V& r0, const V& r1) {
  using Use = Takes<L, O>;
  EdgeTerms<V> t;
  t.between = dot(p0, p1);
  const Three<V> normal = cross(p0, p1);  // length D x u
  const V square = dot(normal, normal);
  const V product = r0 * r1, sum = r0 + r1, reach = sum + e.length;
  // r0 r1 + p0 p1 where the point sees the edge under an acute angle; its quotient |p0 x p1|^2/(r0 r1 - p0 p1) where
  // that would cancel.
  const auto obtuse = less(t.between, V{} + 0.0);
  const V whole = product + magnitude(t.between);
  const V over = select(obtuse, square, whole), under = select(obtuse, whole, V(V{} + 1.0));
  t.inverse = log_of_quotient(V(reach * reach * under), V(over + over), V(V{} + e.length), sum);
  if constexpr (Use::distances || Use::inverse_gradients) {
    const V s = dot(e.u, p0);
    const V twice = s + s + e.length;  // s0 + s1
    const V ratio = twice / sum;       // (r1 - r0)/length
    if constexpr (Use::distances)
      t.distance = (square * t.inverse * e.over * e.over + (sum + twice * ratio) * e.length * 0.5) * 0.5;
    if constexpr (Use::distance_gradients || Use::inverse_gradients) {
      const V step = ratio * e.length;
      Three<V> foot;
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        foot[i] = (normal[k] * e.u[j] - normal[j] * e.u[k]) * e.over;
      }
      if constexpr (Use::distance_gradients)
        for (int i = 0; i < 3; ++i) t.grad_distance[i] = -(step * e.u[i] + t.inverse * foot[i]);
      if constexpr (Use::inverse_gradients) {
        const V over_product = (V{} + 1.0) / (product * over);
        const V cubes = sum * under * e.length * over_product;  // K3
        const V ends = step * over * over_product;              // S3
        const V turn = cubes * e.over;
        for (int i = 0; i < 3; ++i) {
          t.grad_inverse[i] = ends * e.u[i] + cubes * foot[i];
          t.turning[i] = turn * normal[i];
        }
      }
    }
  }
  return t;
}

}  // namespace cageproof::closed_form::batch
