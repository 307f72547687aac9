// SPDX-License-Identifier: MIT
// One face's part of Kelvin's layers and of their derivatives, added to sums over faces.
//
// With H = Hess I, g_k and across_ke = nu_e g_k as of face_terms.h:
//   K (mu = 1) = J Id - beta/2 H,    T_k = B_k Id + (J n - beta H n) g_k' - (J g_k - beta H g_k) n',
//   H n = grad (d J),    H g_k = -sum across_ke grad P_e,    H = n (grad d J)' - sum nu_e (grad P_e)'.
// All of these are functions of the point for one face, except B_k, whose derivatives are those of face_terms.h; so
// derivatives of T and K need only derivatives of J, d J, P and B_k.
//
// One function does all of a face's work, so that its numbers stay in registers.
#pragma once

#include "face_sums.h"

namespace cageproof::closed_form::batch {

template <class V>
struct EdgeGradients;

/// The numbers that derivatives of order O are made of. T: the type of constants.
template <int O, class V, class T>
struct KelvinTerms {
  const FaceTable<T>& face;
  const EdgeTerms<V, O>* const (&edges)[3];
  const EdgeGradients<V> (&gradients)[3];
  const V& beta;
  const V &omega, &d, &J;
  const Three<V> grad_j;
  const V (&B)[2];
  const V (&inverse)[2];  ///< sum across L

  /// \param f the face's number
  [[gnu::always_inline]] void add(int f, const Sums<V>& sums) const {
    const Three<V> n = constant<V>(face.n);
    Symmetric<V, 1> slope;  // grad(d J)
    for (int i = 0; i < 3; ++i) slope[i] = J * n[i] + d * grad_j[i];
    const Symmetric<V, 0> own[2] = {{{B[0]}}, {{B[1]}}};
    add_order<0>(
        f, sums, {{J}}, slope, own, [&](int e) -> const auto& { return gradients[e].distance; });
    V* const last = sums.at(0, 0, face.vertex[2], 9);
    for (int i = 0; i < 3; ++i) last[4 * i] += omega;
    if constexpr (O >= 1) add_gradients(f, sums, n);
    if constexpr (O >= 2) add_hessians(f, sums, n);
  }

 private:
  // Hess J
  Symmetric<V, 2> hessian_of_J(const Three<V>& n) const {
    const Three<V> turn = turning_of_face();
    Symmetric<V, 2> hess;
    for_each_entry<2>([&](int i, int j, int at) {
      hess[at] = n[i] * turn[j] - outward(
                                      i, j, [&](int e) -> const auto& { return gradients[e].inverse; });
    });
    return hess;
  }

  void add_gradients(int f, const Sums<V>& sums, const Three<V>& n) const {
    Symmetric<V, 1> slope, own[2];
    for (int i = 0; i < 3; ++i) {
      slope[i] = grad_j[i];
      for (int k = 0; k < 2; ++k) own[k][i] = omega * face.g[k][i] + inverse[k] * face.n[i];
    }
    const Symmetric<V, 2> hess = hessian_of_J(n);
    Symmetric<V, 2> bend;  // Hess(d J)
    for_each_entry<2>([&](int i, int j, int at) { bend[at] = n[i] * grad_j[j] + (n[j] * grad_j[i] + d * hess[at]); });
    add_order<1>(
        f, sums, slope, bend, own, [&](int e) -> const auto& { return edges[e]->hess_distance; });
  }

  void add_hessians(int f, const Sums<V>& sums, const Three<V>& n) const {
    const Three<V> turn = turning_of_face();
    const Symmetric<V, 2> hess = hessian_of_J(n);
    Symmetric<V, 2> turning, own[2];  // Hess omega, the ring's Hess B
    for (int m = 0; m < 6; ++m)
      turning[m] = edges[0]->turning_slope[m] * face.along[0] + edges[1]->turning_slope[m] * face.along[1] +
                   edges[2]->turning_slope[m] * face.along[2];
    for (int k = 0; k < 2; ++k) {
      Three<V> q;
      for (int i = 0; i < 3; ++i)
        q[i] = inward(
            k, i, [&](int e) -> const auto& { return gradients[e].inverse; });
      for (V& x : own[k].c) x = V{};
      add_symmetric(own[k].c.data(), constant<V>(face.g[k]), turn, n, q);
    }
    Symmetric<V, 3> third;  // of d J
    for_each_entry<3>([&](int i, int m, int at) {
      third[at] = d * (n[i] * turning[m] - outward(
                                               i, m, [&](int e) -> const auto& { return edges[e]->hess_inverse; }));
    });
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        for (int k = j; k < 3; ++k) {
          const int jk = kWith<2>[j][k], at = kWith<3>[i][jk];
          third[at] = third[at] + (n[i] * hess[jk] + n[j] * hess[kWith<2>[i][k]] + n[k] * hess[kWith<2>[i][j]]);
        }
    add_order<2>(
        f, sums, hess, third, own, [&](int e) -> const auto& { return edges[e]->third_distance; });
  }

  // Sums over the edges, of entry m of what `of` takes of each: times its direction, nu_i, and across_k.
  Three<V> turning_of_face() const {
    Three<V> v;
    for (int i = 0; i < 3; ++i) v[i] = gradients[0].turning[i] + gradients[1].turning[i] + gradients[2].turning[i];
    return v;
  }
  template <class Of>
  V outward(int i, int m, Of of) const {
    return of(0)[m] * face.nu[0][i] + of(1)[m] * face.nu[1][i] + of(2)[m] * face.nu[2][i];
  }
  template <class Of>
  V inward(int k, int m, Of of) const {
    return of(0)[m] * face.across[k][0] + of(1)[m] * face.across[k][1] + of(2)[m] * face.across[k][2];
  }

  // Derivatives of order N of J and of the corners' B, of order N + 1 of d J and, by `of`, of each edge's P.
  template <int N, class Of>
  [[gnu::always_inline]] void add_order(int f, const Sums<V>& sums, const Symmetric<V, N>& mean,
                                        const Symmetric<V, N + 1>& high, const Symmetric<V, N> (&own)[2], Of of) const {
    constexpr int kept = kEntries<N>;
    const auto& with = kWith<N + 1>;
    Symmetric<V, N + 2> bulk;  // beta/2 times derivatives of order N of H
    const V half = beta * 0.5;
    for_each_entry<N + 2>([&](int i, int m, int at) { bulk[at] = half * (high[m] * face.n[i] - outward(i, m, of)); });
    V* const displacement = sums.at(N, 1, f, 9 * kept);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int m = 0; m < kept; ++m) {
          const V& x = bulk[kWith<N + 2>[i][with[j][m]]];
          displacement[(3 * i + j) * kept + m] += i == j ? V(mean[m] - x) : V(-x);
        }
    Symmetric<V, N + 1> normal, tangent[2];  // -beta times derivatives of H n, H g
    for (int m = 0; m < kEntries<N + 1>; ++m) {
      normal[m] = -(beta * high[m]);
      for (int k = 0; k < 2; ++k) tangent[k][m] = beta * inward(k, m, of);
    }
    V* const to[2] = {sums.at(N, 0, face.vertex[0], 9 * kept), sums.at(N, 0, face.vertex[1], 9 * kept)};
    V* const last = sums.at(N, 0, face.vertex[2], 9 * kept);
    // Constants are taken before anything is stored, since what is stored might be one of them for all that the
    // compiler knows.
    const Three<V> n = constant<V>(face.n), g[2] = {constant<V>(face.g[0]), constant<V>(face.g[1])};
    for (int m = 0; m < kept; ++m) {
      Three<V> a, b[2];
      for (int i = 0; i < 3; ++i) {
        const int im = with[i][m];
        a[i] = mean[m] * n[i] + normal[im];
        for (int k = 0; k < 2; ++k) b[k][i] = mean[m] * g[k][i] + tangent[k][im];
      }
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const int at = (3 * i + j) * kept + m;
          V x = a[i] * g[0][j] - b[0][i] * n[j], y = a[i] * g[1][j] - b[1][i] * n[j];
          if (i == j) {
            x = x + own[0][m];
            y = y + own[1][m];
          }
          to[0][at] += x;
          to[1][at] += y;
          last[at] += -(x + y);
        }
    }
  }
};

}  // namespace cageproof::closed_form::batch
