// SPDX-License-Identifier: MIT
// Far faces' parts of the coordinates, for one instruction set: layers with hat functions and their derivatives under
// the integral. Unlike the parts of face_terms.h, these are derivatives of the face's own share.
//
// With p from the point to the face, e = n p, G = 1/r, integrals over the face:
//   4 pi phi = int hat e/r^3,  4 pi psi = int 1/r,  8 pi phibar = -int hat e/r,  8 pi psibar = int r,
//   4 pi T = int hat ((1 - beta) (e Id + n p' - p n')/r^3 + 3 beta e p p'/r^5),
//   4 pi K = int ((1 - beta/2) Id/r + beta/2 p p'/r^3),
// and derivatives by the point: grad p = -Id, grad e = -n, grad r^-s = s p r^-(s+2).
#pragma once

#include "far_kelvin.h"
#include "far_moments.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// One far face's part, added to sums.
template <Layers L, int O>
struct FarFace {
  const FaceTable<double>& face;
  const Lanes e;
  const FarMoments<L, O>& m;

  void add(int f, Lanes beta, const Sums<Lanes>& sums) const {
    if constexpr (L == Layers::Kelvin) {
      FarKelvin<O>{face, e, m, beta}.add(f, sums);
    } else {
      for (int k = 0; k < 3; ++k) *sums.at(0, 0, face.vertex[k], 1) += e * m.hats03.of[k][0];
      *sums.at(0, 1, f, 1) += m.sum01.of[0][0];
      if constexpr (O >= 1) {
        add_gradients(sums, 0, 1, 3, m.hats03, m.hats15);
        add_vector(sums.at(1, 1, f, 3), 1, m.sum13);
      }
      if constexpr (O >= 2) {
        add_hessians(sums, 0, 1, 3, 5, m.hats15, m.hats05, m.hats27);
        add_hessian(sums.at(2, 1, f, 6), 3, m.sum25, -1, m.sum03);
      }
      if constexpr (L == Layers::Biharmonic) {
        for (int k = 0; k < 3; ++k) *sums.at(0, 2, face.vertex[k], 1) -= e * m.hats01.of[k][0];
        *sums.at(0, 3, f, 1) += 3 * m.sum0.of[0][0];
        if constexpr (O >= 1) {
          add_gradients(sums, 2, -1, 1, m.hats01, m.hats13);
          add_vector(sums.at(1, 3, f, 3), -1, m.sum11);
        }
        if constexpr (O >= 2) {
          add_hessians(sums, 2, -1, 1, 3, m.hats13, m.hats03, m.hats25);
          add_hessian(sums.at(2, 3, f, 6), -1, m.sum23, 1, m.sum01);
        }
      }
    }
  }

 private:
  template <class Sum>
  void add_vector(Lanes* to, double by, const Sum& sum) const {
    for (int i = 0; i < 3; ++i) to[i] += by * sum.of[0][i];
  }
  // of sign e r^-s: sign (-n r^-s + s e p r^-(s+2))
  template <class Same, class Next>
  void add_gradients(const Sums<Lanes>& sums, int b, double sign, double s, const Same& same, const Next& next) const {
    for (int k = 0; k < 3; ++k) {
      Lanes* const to = sums.at(1, b, face.vertex[k], 3);
      for (int i = 0; i < 3; ++i) to[i] += (sign * s) * (e * next.of[k][i]) - (sign * face.n[i]) * same.of[k][0];
    }
  }
  // and sign s (-n p' - p n' - e Id) r^-(s+2) + sign s (s+2) e p p' r^-(s+4)
  template <class Along, class Round, class Bent>
  void add_hessians(const Sums<Lanes>& sums, int b, double sign, double s, double next, const Along& along,
                    const Round& round, const Bent& bent) const {
    for (int k = 0; k < 3; ++k) {
      Lanes* const to = sums.at(2, b, face.vertex[k], 6);
      for_each_entry<2>([&](int i, int j, int at) {
        Lanes x = next * (e * bent.of[k][at]) - (face.n[i] * along.of[k][j] + face.n[j] * along.of[k][i]);
        if (i == j) x -= e * round.of[k][0];
        to[at] += (sign * s) * x;
      });
    }
  }
  template <class Bent, class Round>
  void add_hessian(Lanes* to, double by, const Bent& bent, double and_by, const Round& round) const {
    for_each_entry<2>([&](int i, int j, int at) {
      Lanes x = by * bent.of[0][at];
      if (i == j) x += and_by * round.of[0][0];
      to[at] += x;
    });
  }
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
