// SPDX-License-Identifier: MIT
// One face and its edges seen from a point by themselves, for arithmetics that are spent on few faces.
#pragma once

#include "face_terms.h"

namespace cageproof::closed_form::batch {

/// A face's corners, edges and solid angle as a point sees them: omega = 2 atan2(across, along).
template <Layers L, int O, class V, class T>
struct SeenFace {
  Three<V> x[3];                               ///< from the point to the corners
  V r[3];                                      ///< their lengths
  EdgeTerms<V, Takes<L, O>::further> edge[3];  ///< of the face's edges, each in its table's direction
  V product;                                   ///< of the lengths
  V across, along;

  /// \param edge_of (i): the table of the face's edge i \param difference (corner, axis): corner less point
  template <class EdgeOf, class Difference>
  SeenFace(const FaceTable<T>& face, EdgeOf edge_of, Difference difference) {
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) x[k][i] = difference(k, i);
      r[k] = root(dot(x[k], x[k]));
    }
    for (int e = 0; e < 3; ++e) {
      const int next = (e + 1) % 3, from = face.along[e] > 0 ? e : next, to = face.along[e] > 0 ? next : e;
      edge[e] = edge_terms<L, O, V, T>(edge_of(e), x[from], x[to], r[from], r[to]);
    }
    product = r[0] * r[1] * r[2];
    across = dot(face.n, x[0]) * face.area2;
    along = product + edge[0].between * r[2] + edge[1].between * r[0] + edge[2].between * r[1];
  }

  /// Adds the face's part to sums. \param omega its solid angle \param beta of Kelvin's layers
  void add(const FaceTable<T>& face, int f, const V& omega, const V& beta, const Sums<V>& sums) const {
    const Three<V>* const corners[3] = {&x[0], &x[1], &x[2]};
    const EdgeTerms<V, Takes<L, O>::further>* const edges[3] = {&edge[0], &edge[1], &edge[2]};
    FaceTerms<L, O, V, T>(face, corners, omega, edges).add(f, beta, sums);
  }
};

}  // namespace cageproof::closed_form::batch
