// SPDX-License-Identifier: MIT
// Sums over faces, and what is added to them.
#pragma once

#include "edge_terms.h"

namespace cageproof::closed_form::batch {

/// Sums over faces, without the factors 1/(4 pi) and 1/(8 pi), mu, and the unit; of psibar's values 3 I.
template <class V>
struct Sums {
  V* columns;
  const Columns* layout;

  V* at(int order, int block, int coordinate, int size) const {
    return columns + layout->first[order][block] + coordinate * size;
  }
};

template <class V>
void add_three(V* to, const Three<V>& v) {
  for (int i = 0; i < 3; ++i) to[i] += v[i];
}
/// The symmetric half of sum of the two products a b'.
template <class V>
void add_symmetric(V* to, const Three<V>& a0, const Three<V>& b0, const Three<V>& a1, const Three<V>& b1) {
  int at = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j, ++at)
      to[at] += i == j ? V(a0[i] * b0[j] + a1[i] * b1[j])
                       : V((a0[i] * b0[j] + a0[j] * b0[i] + a1[i] * b1[j] + a1[j] * b1[i]) * 0.5);
}
template <class V, class T>
Three<V> constant(const T (&c)[3]) {
  return {V{} + c[0], V{} + c[1], V{} + c[2]};
}

}  // namespace cageproof::closed_form::batch
