// SPDX-License-Identifier: MIT
// One face's part of the coordinates of a closed triangle cage, in any arithmetic, added to sums over faces.
//
// Terms that sum to zero over the faces of a vertex of a closed cage are left out, so that gradients and Hessians take
// no derivative of a hat-weighted moment. With w = n x g of a corner's hat function, moments J = int 1/r, I = int r, A
// and B as in the edge form (triangle/engine/edge_form.h), sums over the vertex's faces are
//   4 pi grad phi = sum w x grad J,    8 pi grad phibar = sum (w x grad I + 2 A n),
//   4 pi T = sum B Id + (J - beta Hess I) (n g' - g n'),    mu = 1, beta = 1/(2 (1 - nu)).
// A single face's part is therefore no derivative of that face's share, and Hessians are symmetric only in the sum over
// faces, so the symmetric half of each part is added.
#pragma once

#include "kelvin_terms.h"

namespace cageproof::closed_form::batch {

/// Gradients of one edge's integrals.
template <class V>
struct EdgeGradients {
  Three<V> inverse, distance;  ///< of L, of P
  Three<V> turning;            ///< its part of grad omega
};

/// A face's edges are short where the longest is less than this times the mean distance of edge 0's ends: then each is
/// less than a fifth of the sum of its ends' distances.
inline constexpr double kShort = 1. / 3;
inline double longest_of(const FaceTable<double>& face) {
  const double longer = face.length[0] > face.length[1] ? face.length[0] : face.length[1];
  return longer > face.length[2] ? longer : face.length[2];
}

/// One face seen from the point, and its moments.
template <Layers L, int O, class V, class T>
class FaceTerms {
 public:
  /// \param x from the point to the corners \param omega the solid angle \param edges their terms
  FaceTerms(const FaceTable<T>& face, const Three<V>* const (&x)[3], const V& omega,
            const EdgeTerms<V, Takes<L, O>::further>* const (&edges)[3])
      : face_(face), omega_(omega), edges_(edges) {
    d_ = -dot(face.n, *x[0]);
    V h[3];
    for (int e = 0; e < 3; ++e) h[e] = dot(face.nu[e], *x[e]);
    // Sums over edges of length times a number, after the number of edge 0 is taken off all of them: with
    // edges' normals and slopes of hat functions they are the same, with heights twice the area less.
    rise_[0] = edges[2]->step * face.along[2];     // r0 - r2
    rise_[1] = -(edges[1]->step * face.along[1]);  // r1 - r2
    inverse_of_[0] = edges[0]->tail;
    for (int e = 1; e < 3; ++e)
      inverse_of_[e] = edges[e]->tail + edges[0]->mean * edges[e]->mean * rise_[e - 1] * V(V{} + face.length[e]) * 0.5;
    J_ = h[0] * inverse_of_[0] + h[1] * inverse_of_[1] + h[2] * inverse_of_[2] +
         (edges[0]->mean * face.area2 + d_ * omega);
    if constexpr (Takes<L, O>::distances) {
      distance_of_[0] = edges[0]->bulge;
      for (int e = 1; e < 3; ++e) distance_of_[e] = edges[e]->bulge - rise_[e - 1] * V(V{} + face.length[e]) * 0.5;
    }
    for (int k = 0; k < 2; ++k) {
      hat_[k] = h[k + 1] * face.hat[k];
      inverse_[k] = across(k, inverse_of_);
      B_[k] = hat_[k] * omega + d_ * inverse_[k];
      if constexpr (Takes<L, O>::distances) {
        distance_[k] = across(k, distance_of_);
        A_[k] = hat_[k] * J_ + distance_[k];
      }
    }
    find_gradients(*x[0]);
    if constexpr (L == Layers::Biharmonic)
      thrice_i_ = h[0] * distance_of_[0] + h[1] * distance_of_[1] + h[2] * distance_of_[2] +
                  (edges[0]->sum * face.area2 * 0.5 + d_ * d_ * J_);
  }

  /// \param beta 1/(2 (1 - nu)), of Kelvin's layers
  void add(int f, const V& beta, const Sums<V>& sums) const {
    if constexpr (L == Layers::Kelvin) {
      KelvinTerms<O, V, T>{face_, edges_, gradients_, beta, omega_, d_, J_, gradient_of_J(), B_, inverse_}.add(f, sums);
    } else {
      add_values(f, sums);
      if constexpr (O >= 1) add_gradients(f, sums);
      if constexpr (O >= 2) add_hessians(f, sums);
    }
  }

 private:
  using Use = Takes<L, O>;

  // With m to an edge's middle: grad P = -int p/r = -(L m + skew u), grad L = int p/r3. Where all edges are short for
  // their distance, what sums to nothing is left out, by the vector p0 to corner 0 that they have in common: p0 length
  // mean of grad P and p0 length mean^3 of grad L, with edge 0's mean.
  void find_gradients(const Three<V>& p0) {
    if constexpr (Use::distance_gradients || Use::inverse_gradients) {
      for (int e = 0; e < 3; ++e) {
        if constexpr (Use::distance_gradients) gradients_[e].distance = edges_[e]->grad_distance;
        if constexpr (Use::inverse_gradients) {
          gradients_[e].inverse = edges_[e]->grad_inverse;
          for (int i = 0; i < 3; ++i) gradients_[e].turning[i] = edges_[e]->turning[i] * face_.along[e];
        }
      }
      if constexpr (kReducesGradients<V>) reduce_gradients(p0);
    }
  }
  void reduce_gradients(const Three<V>& p0) {
    const auto brief = longest_of(face_) * edges_[0]->mean < V{} + kShort;
    if (!any(brief)) return;
    const V mean0 = edges_[0]->mean;
    for (int e = 0; e < 3; ++e) {
      EdgeGradients<V>& to = gradients_[e];
      const EdgeTerms<V>& edge = *edges_[e];
      const double* const middle = face_.middle[e];
      const double* const u = face_.u[e];
      if constexpr (Use::distance_gradients)
        for (int i = 0; i < 3; ++i)
          to.distance[i] =
              select(brief, -(p0[i] * inverse_of_[e] + edge.inverse * middle[i] + edge.skew * u[i] * face_.along[e]),
                     to.distance[i]);
      if constexpr (Use::inverse_gradients) {
        V tail = edge.cubes_tail;
        if (e > 0) {
          const V mean = edge.mean, difference = 0.5 * mean0 * mean * rise_[e - 1];
          tail += face_.length[e] * difference * (mean * mean + mean * mean0 + mean0 * mean0);
        }
        Three<V> p;
        for (int i = 0; i < 3; ++i) {
          p[i] = p0[i] * tail + edge.cubes * middle[i];
          to.inverse[i] = select(brief, p[i] + edge.cubes_skew * u[i] * face_.along[e], to.inverse[i]);
        }
        for (int i = 0; i < 3; ++i) {
          const int j = (i + 1) % 3, k = (i + 2) % 3;
          to.turning[i] = select(brief, p[j] * u[k] - p[k] * u[j], to.turning[i]);
        }
      }
    }
  }

  V across(int k, const V (&of)[3]) const {
    return of[0] * face_.across[k][0] + of[1] * face_.across[k][1] + of[2] * face_.across[k][2];
  }
  // omega n - sum L nu
  Three<V> gradient_of_J() const {
    Three<V> v;
    for (int i = 0; i < 3; ++i)
      v[i] = omega_ * face_.n[i] -
             (inverse_of_[0] * face_.nu[0][i] + inverse_of_[1] * face_.nu[1][i] + inverse_of_[2] * face_.nu[2][i]);
    return v;
  }
  // grad(d J) = J n + d grad J
  Three<V> slope_of(const Three<V>& grad_J) const {
    Three<V> v;
    for (int i = 0; i < 3; ++i) v[i] = J_ * face_.n[i] + d_ * grad_J[i];
    return v;
  }

  void add_values(int f, const Sums<V>& sums) const {
    for (int k = 0; k < 2; ++k) *sums.at(0, 0, face_.vertex[k], 1) += B_[k];
    *sums.at(0, 0, face_.vertex[2], 1) += omega_ - B_[0] - B_[1];
    *sums.at(0, 1, f, 1) += J_;
    if constexpr (L == Layers::Biharmonic) {
      for (int k = 0; k < 2; ++k) *sums.at(0, 2, face_.vertex[k], 1) += d_ * A_[k];
      *sums.at(0, 2, face_.vertex[2], 1) += d_ * (J_ - A_[0] - A_[1]);
      *sums.at(0, 3, f, 1) += thrice_i_;
    }
  }

  void add_gradients(int f, const Sums<V>& sums) const {
    add_three(sums.at(1, 1, f, 3), gradient_of_J());
    V* const last = sums.at(1, 0, face_.vertex[2], 3);
    for (int k = 0; k < 2; ++k) {
      V* const to = sums.at(1, 0, face_.vertex[k], 3);
      for (int i = 0; i < 3; ++i) {
        const V x = omega_ * face_.g[k][i] + inverse_[k] * face_.n[i];
        to[i] += x;
        last[i] += -x;
      }
    }
    if constexpr (L == Layers::Biharmonic) {
      const V dJ = d_ * J_;
      V* const own = sums.at(1, 3, f, 3);
      for (int i = 0; i < 3; ++i)
        own[i] += dJ * face_.n[i] - (distance_of_[0] * face_.nu[0][i] + distance_of_[1] * face_.nu[1][i] +
                                     distance_of_[2] * face_.nu[2][i]);
      V* const rest = sums.at(1, 2, face_.vertex[2], 3);
      for (int i = 0; i < 3; ++i) rest[i] += (J_ + J_) * face_.n[i];
      for (int k = 0; k < 2; ++k) {
        V* const to = sums.at(1, 2, face_.vertex[k], 3);
        const V normal = A_[k] + A_[k] + distance_[k];
        for (int i = 0; i < 3; ++i) {
          const V x = dJ * face_.g[k][i] + normal * face_.n[i];
          to[i] += x;
          rest[i] += -x;
        }
      }
    }
  }

  void add_hessians(int f, const Sums<V>& sums) const {
    const Three<V> n = constant<V>(face_.n);
    Three<V> turn;  // grad omega
    for (int i = 0; i < 3; ++i)
      turn[i] = gradients_[0].turning[i] + gradients_[1].turning[i] + gradients_[2].turning[i];
    add_own(sums.at(2, 1, f, 6), n, turn, [](const EdgeGradients<V>& e) -> const Three<V>& { return e.inverse; });
    add_corners(sums, 0, turn, [](const EdgeGradients<V>& e) -> const Three<V>& { return e.inverse; });
    if constexpr (L == Layers::Biharmonic) {
      const Three<V> grad_J = gradient_of_J(), slope = slope_of(grad_J);
      add_own(sums.at(2, 3, f, 6), n, slope, [](const EdgeGradients<V>& e) -> const Three<V>& { return e.distance; });
      V* const last = sums.at(2, 2, face_.vertex[2], 6);
      const Three<V> zero{{V{}, V{}, V{}}};
      const Three<V> twice{{grad_J[0] + grad_J[0], grad_J[1] + grad_J[1], grad_J[2] + grad_J[2]}};
      add_symmetric(last, n, twice, zero, zero);
      for (int k = 0; k < 2; ++k) {
        Three<V> q;
        for (int i = 0; i < 3; ++i) {
          const V rest = gradients_[0].distance[i] * face_.across[k][0] +
                         gradients_[1].distance[i] * face_.across[k][1] +
                         gradients_[2].distance[i] * face_.across[k][2];
          q[i] = (J_ + J_) * face_.g[k][i] + hat_[k] * twice[i] + rest + rest + rest;
        }
        add_pair(sums, 2, k, slope, q);
      }
    }
  }

  // n w' - sum nu (grad of an edge's integral)', which is symmetric.
  template <class Of>
  void add_own(V* to, const Three<V>& n, const Three<V>& w, Of of) const {
    int at = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++at)
        to[at] += n[i] * w[j] - (of(gradients_[0])[j] * face_.nu[0][i] + of(gradients_[1])[j] * face_.nu[1][i] +
                                 of(gradients_[2])[j] * face_.nu[2][i]);
  }

  template <class Of>
  void add_corners(const Sums<V>& sums, int block, const Three<V>& turn, Of of) const {
    for (int k = 0; k < 2; ++k) {
      Three<V> q;
      for (int i = 0; i < 3; ++i)
        q[i] = of(gradients_[0])[i] * face_.across[k][0] + of(gradients_[1])[i] * face_.across[k][1] +
               of(gradients_[2])[i] * face_.across[k][2];
      add_pair(sums, block, k, turn, q);
    }
  }
  // g w' + n q' of corner k without the part that corners have in common; the third corner has the opposite.
  void add_pair(const Sums<V>& sums, int block, int k, const Three<V>& w, const Three<V>& q) const {
    V part[6];
    for (V& x : part) x = V{};
    add_symmetric(part, constant<V>(face_.g[k]), w, constant<V>(face_.n), q);
    V* const to = sums.at(2, block, face_.vertex[k], 6);
    V* const last = sums.at(2, block, face_.vertex[2], 6);
    for (int i = 0; i < 6; ++i) {
      to[i] += part[i];
      last[i] += -part[i];
    }
  }

  const FaceTable<T>& face_;
  const V omega_;
  const EdgeTerms<V, Takes<L, O>::further>* const (&edges_)[3];
  EdgeGradients<V> gradients_[3];
  V rise_[2];
  V inverse_of_[3], distance_of_[3];  // of edges: L and P, less what sums to nothing
  V d_, J_, thrice_i_, hat_[2], inverse_[2], distance_[2], B_[2], A_[2];
};

}  // namespace cageproof::closed_form::batch
