// SPDX-License-Identifier: MIT
// One edge's and one face's part of the coordinates of a closed triangle cage, in any arithmetic.
//
// Source: formulas as in the edge form (triangle/engine/edge_form.h), with what sums to nothing over a closed cage left
// out, so that gradients and Hessians take no derivative of a hat-weighted moment: with w = n x g of a corner's hat
// function, sums over the vertex's faces are
//   4 pi grad phi = sum w x grad J,   8 pi grad phibar = sum (w x grad I + 2 A n),
//   4 pi T = sum B Id + (J - beta Hess I)(n g' - g n'),   mu = 1, beta = 1/(2 (1 - nu)).
// A single face's part is therefore no coordinate of that face.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

#include <array>

namespace cageproof::closed_form::batch {

template <class V>
using Three = std::array<V, 3>;

template <class V, class T>
V dot(const Three<T>& constant, const Three<V>& v) {
  return v[0] * constant[0] + v[1] * constant[1] + v[2] * constant[2];
}
template <class V>
V dot_of(const Three<V>& a, const Three<V>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Which integrals over edges the layers take for derivatives up to an order.
template <Layers L, int O>
struct Takes {
  static constexpr bool distances = L != Layers::Harmonic;  ///< int r
  static constexpr bool distance_gradients = L == Layers::Kelvin || (L == Layers::Biharmonic && O == 2);
  static constexpr bool inverse_gradients = O == 2;  ///< grad int 1/r
};

/// Integrals over one edge, in its table's direction.
template <class V>
struct EdgeTerms {
  V inverse{};               ///< L = int 1/r
  V distance{};              ///< P = int r
  Three<V> grad_inverse{};   ///< grad L
  Three<V> grad_distance{};  ///< grad P
  Three<V> turning{};        ///< its part of grad omega: K3 D x u
  V between{};               ///< the scalar product of the vectors to its ends
};

/// \param p0, p1 from the point to the edge's ends \param r0, r1 their lengths
template <Layers L, int O, class V, class T>
EdgeTerms<V> edge_terms(const EdgeTable<T>& e, const Three<V>& p0, const Three<V>& p1, const V& r0, const V& r1) {
  using Use = Takes<L, O>;
  EdgeTerms<V> t;
  t.between = dot_of(p0, p1);
  const Three<V> normal{p0[1] * p1[2] - p0[2] * p1[1], p0[2] * p1[0] - p0[0] * p1[2], p0[0] * p1[1] - p0[1] * p1[0]};
  const V square = dot_of(normal, normal);  // of length times the distance of the line
  const V product = r0 * r1, sum = r0 + r1;
  // (r0 r1 + p0 p1) without cancellation where the point sees the edge under an obtuse angle: a quotient, whose
  // denominator goes to the other side.
  const auto obtuse = less(t.between, V{});
  const V whole = product + magnitude(t.between);
  const V over = select(obtuse, square, whole);
  const V under = select(obtuse, whole, V{} + 1.0);
  const V reach = sum + e.length;
  t.inverse = log_of_quotient(V(reach * reach * under), V(over + over), V(V{} + e.length), sum);
  if constexpr (Use::distances) {
    const V s = dot(e.u, p0);
    const V twice = s + s + e.length;  // s0 + s1
    const V mean = sum + twice * twice / sum;
    t.distance = (square * (t.inverse * (e.over * e.over)) + mean * (e.length * 0.5)) * 0.5;
    if constexpr (Use::distance_gradients || Use::inverse_gradients) {
      const V step = twice * e.length / sum;  // r1 - r0
      const Three<V> foot{(e.u[1] * 1.0) * normal[2] * e.over - normal[1] * (e.u[2] * e.over),
                          normal[0] * (e.u[2] * e.over) - normal[2] * (e.u[0] * e.over),
                          normal[1] * (e.u[0] * e.over) - normal[0] * (e.u[1] * e.over)};
      for (int i = 0; i < 3; ++i) t.grad_distance[i] = V{} - (step * e.u[i] + t.inverse * foot[i]);
    }
  }
  if constexpr (Use::inverse_gradients) {
    const V s = dot(e.u, p0);
    const V step = (s + s + e.length) * e.length / sum;
    const V cubes = sum * under * e.length / (product * over);  // int r^-3
    const V ends = step / product;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const V foot = (normal[k] * e.u[j] - normal[j] * e.u[k]) * e.over;
      t.grad_inverse[i] = ends * e.u[i] + cubes * foot;
      t.turning[i] = cubes * normal[i] * e.over;
    }
  }
  return t;
}

}  // namespace cageproof::closed_form::batch
