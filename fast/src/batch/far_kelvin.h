// SPDX-License-Identifier: MIT
// A far face's part of Kelvin's layers and of their derivatives, for one instruction set; far_faces.h has the formulas.
#pragma once

#include "face_sums.h"
#include "far_moments.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

template <int O>
struct FarKelvin {
  const FaceTable<double>& face;
  const Lanes e;
  const FarMoments<Layers::Kelvin, O>& m;
  const Lanes beta;

  void add(int f, const Sums<Lanes>& sums) const {
    const double* const n = face.n;
    const Lanes rest = 1 - beta, half = beta * 0.5, triple = 3 * beta;
    for (int k = 0; k < 3; ++k) {
      Lanes* const to = sums.at(0, 0, face.vertex[k], 9);
      const Symmetric<Lanes, 1>& p = m.hats13.of[k];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          Lanes x = triple * (e * m.hats25.of[k][kWith<2>[i][j]]) + rest * (n[i] * p[j] - n[j] * p[i]);
          if (i == j) x += rest * (e * m.hats03.of[k][0]);
          to[3 * i + j] += x;
        }
    }
    Lanes* const to = sums.at(0, 1, f, 9);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Lanes x = half * m.sum23.of[0][kWith<2>[i][j]];
        if (i == j) x += (1 - half) * m.sum01.of[0][0];
        to[3 * i + j] += x;
      }
    if constexpr (O >= 1) add_gradients(f, sums);
    if constexpr (O >= 2) add_hessians(f, sums);
  }

 private:
  // Entries of symmetric tensors by all of their indices.
  static constexpr int at(int i, int j) { return kWith<2>[i][j]; }
  static constexpr int at(int i, int j, int l) { return kWith<3>[i][kWith<2>[j][l]]; }
  static constexpr int at(int i, int j, int l, int q) { return kWith<4>[i][at(j, l, q)]; }

  void add_gradients(int f, const Sums<Lanes>& sums) const {
    const double* const n = face.n;
    const Lanes rest = 1 - beta, half = beta * 0.5, triple = 3 * beta;
    for (int k = 0; k < 3; ++k) {
      Lanes* const to = sums.at(1, 0, face.vertex[k], 27);
      const Lanes cubes = m.hats03.of[k][0];
      const Symmetric<Lanes, 1>& p = m.hats15.of[k];
      const Symmetric<Lanes, 2>& pp = m.hats25.of[k];
      const Symmetric<Lanes, 3>& ppp = m.hats37.of[k];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int l = 0; l < 3; ++l) {
            Lanes x = 3 * (n[i] * pp[at(j, l)] - n[j] * pp[at(i, l)]);
            if (i == j) x += 3 * (e * p[l]) - n[l] * cubes;
            if (j == l) x -= n[i] * cubes;
            if (i == l) x += n[j] * cubes;
            Lanes y = 5 * (e * ppp[at(i, j, l)]) - n[l] * pp[at(i, j)];
            if (i == l) y -= e * p[j];
            if (j == l) y -= e * p[i];
            to[(3 * i + j) * 3 + l] += rest * x + triple * y;
          }
    }
    Lanes* const to = sums.at(1, 1, f, 27);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l) {
          Lanes x = 3 * m.sum35.of[0][at(i, j, l)];
          if (i == l) x -= m.sum13.of[0][j];
          if (j == l) x -= m.sum13.of[0][i];
          x *= half;
          if (i == j) x += (1 - half) * m.sum13.of[0][l];
          to[(3 * i + j) * 3 + l] += x;
        }
  }

  void add_hessians(int f, const Sums<Lanes>& sums) const {
    const double* const n = face.n;
    const Lanes rest = 1 - beta, half = beta * 0.5, triple = 3 * beta;
    for (int k = 0; k < 3; ++k) {
      Lanes* const to = sums.at(2, 0, face.vertex[k], 54);
      const Lanes fifths = m.hats05.of[k][0];
      const Symmetric<Lanes, 1>& p = m.hats15.of[k];
      const Symmetric<Lanes, 2>& pp = m.hats27.of[k];
      const Symmetric<Lanes, 3>& ppp = m.hats37.of[k];
      const Symmetric<Lanes, 4>& pppp = m.hats49.of[k];
      // e Id + n p' - p n' times p_l p_q r^-7, and without the p_l p_q times r^-5.
      const auto turned = [&](int i, int j, const auto& with) {
        Lanes x = n[i] * with(j) - n[j] * with(i);
        return x;
      };
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for_each_entry<2>([&](int l, int q, int place) {
            const auto skew = [&](int a, int b) {  // grad_a of (e Id + n p' - p n')_ij, times p_b
              Lanes x{};
              if (i == j) x -= n[a] * p[b];
              if (j == a) x -= n[i] * p[b];
              if (i == a) x += n[j] * p[b];
              return x;
            };
            Lanes x = skew(l, q) + skew(q, l);
            x += 5 * turned(i, j, [&](int c) { return ppp[at(c, l, q)]; });
            if (i == j) x += 5 * (e * pp[at(l, q)]);
            if (l == q) {
              x -= turned(i, j, [&](int c) { return p[c]; });
              if (i == j) x -= e * fifths;
            }
            Lanes y = 35 * (e * pppp[at(i, j, l, q)]) - 5 * (n[l] * ppp[at(i, j, q)] + n[q] * ppp[at(i, j, l)]);
            const auto side = [&](int a, int b) {  // n_b grad_a (p_i p_j)
              Lanes z{};
              if (i == a) z += n[b] * p[j];
              if (j == a) z += n[b] * p[i];
              return z;
            };
            y += side(l, q) + side(q, l);
            if (i == l) y -= 5 * (e * pp[at(j, q)]);
            if (j == l) y -= 5 * (e * pp[at(i, q)]);
            if (i == q) y -= 5 * (e * pp[at(j, l)]);
            if (j == q) y -= 5 * (e * pp[at(i, l)]);
            if (l == q) y -= 5 * (e * pp[at(i, j)]);
            if (i == l && j == q) y += e * fifths;
            if (i == q && j == l) y += e * fifths;
            to[(3 * i + j) * 6 + place] += (3 * rest) * x + triple * y;
          });
    }
    Lanes* const to = sums.at(2, 1, f, 54);
    const Symmetric<Lanes, 2>& pp = m.sum25.of[0];
    const Lanes cubes = m.sum03.of[0][0];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for_each_entry<2>([&](int l, int q, int place) {
          Lanes x = 15 * m.sum47.of[0][at(i, j, l, q)];
          if (i == l) x -= 3 * pp[at(j, q)];
          if (j == l) x -= 3 * pp[at(i, q)];
          if (i == q) x -= 3 * pp[at(j, l)];
          if (j == q) x -= 3 * pp[at(i, l)];
          if (l == q) x -= 3 * pp[at(i, j)];
          if (i == l && j == q) x += cubes;
          if (i == q && j == l) x += cubes;
          x *= half;
          if (i == j) {
            x += (1 - half) * (3 * pp[at(l, q)]);
            if (l == q) x -= (1 - half) * cubes;
          }
          to[(3 * i + j) * 6 + place] += x;
        });
  }
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
