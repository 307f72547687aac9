// SPDX-License-Identifier: MIT
// Integrals over a far face by a rule's points, for one instruction set: products of the vector p from the point to the
// face, over odd powers of its length r, with hat functions and without.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"
#include "cageproof/closed_form/batch/tables.h"

#include "far_rules.h"
#include "symmetric.h"
#include "vectors.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Whether layers and their derivatives up to order O take int hat p^rank/r^power.
template <Layers L, int O>
constexpr bool takes_hats(int rank, int power) {
  if (L == Layers::Kelvin)
    return (power == 3 && rank <= 1) || (power == 5 && rank == 2) || (O >= 1 && power == 5 && rank == 1) ||
           (O >= 1 && power == 7 && rank == 3) || (O == 2 && power == 5 && rank == 0) ||
           (O == 2 && power == 7 && rank == 2) || (O == 2 && power == 9 && rank == 4);
  // n p/r^3 and its derivatives; n p/r and its derivatives.
  const bool harmonic = (power == 3 + 2 * rank && rank <= O) || (O == 2 && power == 5 && rank == 0);
  const bool biharmonic = (power == 1 + 2 * rank && rank <= O) || (O == 2 && power == 3 && rank == 0);
  return harmonic || (L == Layers::Biharmonic && biharmonic);
}
/// The same of int p^rank/r^power.
template <Layers L, int O>
constexpr bool takes_sums(int rank, int power) {
  if (L == Layers::Kelvin)
    return (power == 1 && rank == 0) || (power == 3 && rank == 2) || (O >= 1 && power == 3 && rank == 1) ||
           (O >= 1 && power == 5 && rank == 3) || (O == 2 && power == 3 && rank == 0) ||
           (O == 2 && power == 5 && rank == 2) || (O == 2 && power == 7 && rank == 4);
  // 1/r and its derivatives; r and its derivatives.
  const bool harmonic = (power == 1 + 2 * rank && rank <= O) || (O == 2 && power == 3 && rank == 0);
  const bool biharmonic = (power == -1 + 2 * rank && rank <= O);
  return harmonic || (L == Layers::Biharmonic && biharmonic);
}

/// Points that are taken at a time, so that sums are seldom fetched and put back.
inline constexpr int kAtOnce = 4;

/// The weights of as many points: hat functions, and all of the area.
struct Weights {
  Lanes of[kAtOnce][4];
};

/// Sums over points: of each hat function where there are three, else of all of the area.
template <bool Taken, int Rank, int Sets>
struct Summed {
  Symmetric<Lanes, Rank> of[Sets] = {};

  [[gnu::always_inline]] void add(const Symmetric<Lanes, Rank> (&x)[kAtOnce], const Lanes (&power)[kAtOnce],
                                  const Weights& weights) {
    for (int m = 0; m < kEntries<Rank>; ++m) {
      Lanes sum[Sets];
      for (int k = 0; k < Sets; ++k) sum[k] = of[k][m];
      for (int q = 0; q < kAtOnce; ++q) {
        const Lanes term = Rank == 0 ? power[q] : x[q][m] * power[q];
        for (int k = 0; k < Sets; ++k) sum[k] += term * weights.of[q][Sets == 1 ? 3 : k];
      }
      for (int k = 0; k < Sets; ++k) of[k][m] = sum[k];
    }
  }
  void scale(double by, Mask points) {
    for (auto& set : of)
      for (int m = 0; m < kEntries<Rank>; ++m) set[m] = select(points, set[m] * by, Lanes{});
  }
};
template <int Rank, int Sets>
struct Summed<false, Rank, Sets> {
  void add(const Symmetric<Lanes, Rank> (&)[kAtOnce], const Lanes (&)[kAtOnce], const Weights&) {}
  void scale(double, Mask) {}
};

/// From products of order N - 1 those of order N.
template <int N>
[[gnu::always_inline]] inline Symmetric<Lanes, N> times(const Three<Lanes>& p, const Symmetric<Lanes, N - 1>& rest) {
  Symmetric<Lanes, N> product;
  for_each_entry<N>([&](int i, int m, int at) { product[at] = p[i] * rest[m]; });
  return product;
}

template <Layers L, int O>
struct FarMoments {
  template <int Rank, int Power>
  using Hats = Summed<takes_hats<L, O>(Rank, Power), Rank, 3>;
  template <int Rank, int Power>
  using Sums = Summed<takes_sums<L, O>(Rank, Power), Rank, 1>;

  // Named by rank and power.
  Hats<0, 1> hats01;
  Hats<0, 3> hats03;
  Hats<0, 5> hats05;
  Hats<1, 3> hats13;
  Hats<1, 5> hats15;
  Hats<2, 5> hats25;
  Hats<2, 7> hats27;
  Hats<3, 7> hats37;
  Hats<4, 9> hats49;
  Sums<0, -1> sum0;
  Sums<0, 1> sum01;
  Sums<0, 3> sum03;
  Sums<1, 1> sum11;
  Sums<1, 3> sum13;
  Sums<2, 3> sum23;
  Sums<2, 5> sum25;
  Sums<3, 5> sum35;
  Sums<4, 7> sum47;

  /// \param corner from the point to corner 0 \param edges from there to corners 1 and 2 \param points
  /// of which integrals are wanted: those of others are zero
  FarMoments(const FarRule& rule, const Three<Lanes>& corner, const double (&edges)[2][3], double area, Mask points) {
    // Where the points lie, as many at a time as a vector holds, with points of no weight to the last of kAtOnce.
    const int padded = (rule.nodes + kAtOnce - 1) / kAtOnce * kAtOnce;
    static_assert(kPaddedNodes % kAtOnce == 0 && kPaddedNodes % kLanes == 0);
    alignas(64) double offset[3][kPaddedNodes];
    for (int q = 0; q < padded; q += kLanes)
      for (int i = 0; i < 3; ++i) {
        Lanes a, b;
        __builtin_memcpy(&a, rule.along[0] + q, sizeof a);
        __builtin_memcpy(&b, rule.along[1] + q, sizeof b);
        const Lanes at = a * edges[0][i] + b * edges[1][i];
        __builtin_memcpy(offset[i] + q, &at, sizeof at);
      }
    for (int first = 0; first < rule.nodes; first += kAtOnce) {
      Weights w;
      Symmetric<Lanes, 0> one[kAtOnce];
      Symmetric<Lanes, 1> p1[kAtOnce];
      Symmetric<Lanes, 2> p2[kAtOnce];
      Symmetric<Lanes, 3> p3[kAtOnce];
      Symmetric<Lanes, 4> p4[kAtOnce];
      Lanes r[kAtOnce], g[kAtOnce], g3[kAtOnce], g5[kAtOnce], g7[kAtOnce], g9[kAtOnce];
      for (int q = 0; q < kAtOnce; ++q) {
        for (int k = 0; k < 4; ++k) w.of[q][k] = splat(rule.weight[first + q][k]);
        Three<Lanes> p;
        for (int i = 0; i < 3; ++i) p1[q][i] = p[i] = corner[i] + offset[i][first + q];
        const Lanes square = dot(p, p);
        g[q] = over_root(square);
        const Lanes g2 = g[q] * g[q];
        r[q] = square * g[q];
        g3[q] = g[q] * g2;
        g5[q] = g3[q] * g2;
        g7[q] = g5[q] * g2;
        g9[q] = g7[q] * g2;
        p2[q] = times<2>(p, p1[q]);
        p3[q] = times<3>(p, p2[q]);
        p4[q] = times<4>(p, p3[q]);
      }
      hats01.add(one, g, w);
      hats03.add(one, g3, w);
      hats05.add(one, g5, w);
      hats13.add(p1, g3, w);
      hats15.add(p1, g5, w);
      hats25.add(p2, g5, w);
      hats27.add(p2, g7, w);
      hats37.add(p3, g7, w);
      hats49.add(p4, g9, w);
      sum0.add(one, r, w);
      sum01.add(one, g, w);
      sum03.add(one, g3, w);
      sum11.add(p1, g, w);
      sum13.add(p1, g3, w);
      sum23.add(p2, g3, w);
      sum25.add(p2, g5, w);
      sum35.add(p3, g5, w);
      sum47.add(p4, g7, w);
    }
    const auto scale = [&](auto&... sums) { (sums.scale(area, points), ...); };
    scale(hats01, hats03, hats05, hats13, hats15, hats25, hats27, hats37, hats49, sum0, sum01, sum03, sum11, sum13,
          sum23, sum25, sum35, sum47);
  }
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
