// SPDX-License-Identifier: MIT
// Derivatives of one edge's integrals beyond those of harmonic and biharmonic layers, for Kelvin's.
//
// With Q = Id - u u', and [] the sum over the places that a vector may stand in, those of the edge form
// (triangle/engine/edge_form.h) and one more:
//   Hess P = L Q + K3 (D2 u u' - D D') - S3 (u D' + D u'),
//   Hess L = -K3 Q + (2 K3 - 3 K5 D2) u u' + 3 S5 (u D' + D u') + 3 K5 D D',
//   third derivatives of P = S3 [u Q] + K3 [D Q] + 3 S5 D2 u u u + (3 K5 D2 - 2 K3) [D u u] - 3 S5 [u D D]
//                            - 3 K5 D D D.
// Their terms are no larger than the results, near the edge's line and far from it.
#pragma once

#include "symmetric.h"
#include "vectors.h"

namespace cageproof::closed_form::batch {

/// The numbers that an edge's derivatives are made of.
template <class V>
struct EdgeFrame {
  Three<V> u, foot, normal;  ///< direction; D; D x u
  V square;                  ///< |D|^2
  V inverse, cubes, ends;    ///< L, K3, S3
  V fifths, fifth_ends;      ///< 3 K5, 3 S5; hess_distance() does not need them
};

template <class V>
Symmetric<V, 2> hess_distance(const EdgeFrame<V>& e) {
  Symmetric<V, 2> hess;
  const V flat = e.cubes * e.square - e.inverse;
  for_each_entry<2>([&](int i, int j, int at) {
    const V x = (flat * e.u[i] - e.ends * e.foot[i]) * e.u[j] - (e.ends * e.u[i] + e.cubes * e.foot[i]) * e.foot[j];
    hess[at] = i == j ? V(e.inverse + x) : x;
  });
  return hess;
}

template <class V>
Symmetric<V, 2> hess_inverse(const EdgeFrame<V>& e, const Three<V>& grad_cubes) {
  Symmetric<V, 2> hess;
  const V flat = e.cubes + e.cubes + e.cubes - e.fifths * e.square;
  for_each_entry<2>([&](int i, int j, int at) {
    const V x = (flat * e.u[i] + e.fifth_ends * e.foot[i]) * e.u[j] + grad_cubes[i] * e.foot[j];
    hess[at] = i == j ? V(x - e.cubes) : x;
  });
  return hess;
}

/// The edge's part of Hess omega: the symmetric half of (D x u) (grad K3)'. The rest sums to nothing over a face.
template <class V>
Symmetric<V, 2> slope_of_turning(const EdgeFrame<V>& e, const Three<V>& grad_cubes) {
  Symmetric<V, 2> slope;
  for_each_entry<2>([&](int i, int j, int at) {
    slope[at] =
        i == j ? V(e.normal[i] * grad_cubes[i]) : V((e.normal[i] * grad_cubes[j] + e.normal[j] * grad_cubes[i]) * 0.5);
  });
  return slope;
}

/// \param grad_inverse grad L
template <class V>
Symmetric<V, 3> third_distance(const EdgeFrame<V>& e, const Three<V>& grad_inverse) {
  // [a Id] + [b u u] - [c D D], a = grad L
  const V third = (V{} + 1.0) / (V{} + 3.0);  // in the arithmetic's digits
  const V flat = e.fifths * e.square - (e.cubes + e.cubes + e.cubes);
  const V along = e.fifth_ends * third * e.square - e.ends;
  const V across = e.fifths * third;
  Three<V> b, c;
  for (int i = 0; i < 3; ++i) {
    b[i] = along * e.u[i] + flat * e.foot[i];
    c[i] = e.fifth_ends * e.u[i] + across * e.foot[i];
  }
  Symmetric<V, 2> uu, dd;
  for_each_entry<2>([&](int i, int j, int at) {
    uu[at] = e.u[i] * e.u[j];
    dd[at] = e.foot[i] * e.foot[j];
  });
  Symmetric<V, 3> t;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = j; k < 3; ++k) {
        const int jk = kWith<2>[j][k], ik = kWith<2>[i][k], ij = kWith<2>[i][j];
        V x = (b[i] * uu[jk] + b[j] * uu[ik] + b[k] * uu[ij]) - (c[i] * dd[jk] + c[j] * dd[ik] + c[k] * dd[ij]);
        if (j == k) x = x + grad_inverse[i];
        if (i == k) x = x + grad_inverse[j];
        if (i == j) x = x + grad_inverse[k];
        t[kWith<3>[i][jk]] = x;
      }
  return t;
}

}  // namespace cageproof::closed_form::batch
