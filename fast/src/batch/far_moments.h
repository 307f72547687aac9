// SPDX-License-Identifier: MIT
// Integrals over a far face by a rule's points, for one instruction set: products of the vector p from the point to the
// face, over powers of its length r, with hat functions and without.
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
  if (L == Layers::MeanValue) return (power == 4 + 2 * rank && rank <= O) || (O == 2 && power == 6 && rank == 0);
  // n p/r^3 and its derivatives; n p/r and its derivatives.
  const bool harmonic = (power == 3 + 2 * rank && rank <= O) || (O == 2 && power == 5 && rank == 0);
  const bool biharmonic = (power == 1 + 2 * rank && rank <= O) || (O == 2 && power == 3 && rank == 0);
  return harmonic || (L == Layers::Biharmonic && biharmonic);
}
/// Whether the layers take sums of int p^rank/r^power.
template <Layers L, int O>
constexpr bool takes_sums(int rank, int power) {
  if (L == Layers::Kelvin)
    return (power == 1 && rank == 0) || (power == 3 && rank == 2) || (O >= 1 && power == 3 && rank == 1) ||
           (O >= 1 && power == 5 && rank == 3) || (O == 2 && power == 3 && rank == 0) ||
           (O == 2 && power == 5 && rank == 2) || (O == 2 && power == 7 && rank == 4);
  if (L == Layers::MeanValue) return false;
  // 1/r and its derivatives; r and its derivatives.
  const bool harmonic = (power == 1 + 2 * rank && rank <= O) || (O == 2 && power == 3 && rank == 0);
  const bool biharmonic = (power == -1 + 2 * rank && rank <= O);
  return harmonic || (L == Layers::Biharmonic && biharmonic);
}

/// Points of a rule that are taken at a time, so that sums are seldom fetched and put back.
inline constexpr int kAtOnce = 2;

/// The place of a^i b^j among monomials by rising degree.
constexpr int monomial_at(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

/// The highest degree of monomials over r^power whose integrals are needed; -1 where none are. Hat functions have one
/// degree.
template <Layers L, int O>
constexpr int degree_over(int power) {
  int degree = -1;
  for (int rank = 0; rank <= 4; ++rank) {
    if (takes_sums<L, O>(rank, power) && degree < rank) degree = rank;
    if (takes_hats<L, O>(rank, power) && degree < rank + 1) degree = rank + 1;
  }
  return degree;
}

/// Integrals of monomials of a and b over one power of r, at points corner 0 + a edge 0 + b edge 1.
template <int Degree>
struct Monomials {
  static constexpr int count = (Degree + 1) * (Degree + 2) / 2;
  Lanes of[count] = {};

  [[gnu::always_inline]] void add(const Lanes (&power)[kAtOnce], const double (*weights)[kMostMonomials]) {
    for (int m = 0; m < count; ++m) {
      Lanes sum = of[m];
      for (int q = 0; q < kAtOnce; ++q) sum += power[q] * weights[q][m];
      of[m] = sum;
    }
  }
  void scale(double by, Mask points) {
    for (Lanes& sum : of) sum = select(points, sum * by, Lanes{});
  }
};
template <>
struct Monomials<-1> {
  void add(const Lanes (&)[kAtOnce], const double (*)[kMostMonomials]) {}
  void scale(double, Mask) {}
};

/// A face as the points see it: the vector to corner 0, and the edges from there to corners 1 and 2.
struct FarCorner {
  const Three<Lanes>& x;
  const double (&edges)[2][3];

  /// int p^Rank/r^power from integrals of monomials up to that degree: p is x and a and b times the edges.
  template <int Rank, class Of>
  [[gnu::always_inline]] Symmetric<Lanes, Rank> tensor(Of of) const {
    Symmetric<Lanes, Rank> product;
    if constexpr (Rank == 0) {
      product[0] = of(0, 0);
    } else {
      const auto rest = tensor<Rank - 1>(of);
      const auto along = tensor<Rank - 1>([&](int i, int j) { return of(i + 1, j); });
      const auto across = tensor<Rank - 1>([&](int i, int j) { return of(i, j + 1); });
      for_each_entry<Rank>([&](int i, int m, int at) {
        product[at] = x[i] * rest[m] + (along[m] * edges[0][i] + across[m] * edges[1][i]);
      });
    }
    return product;
  }
};

/// Integrals of p^Rank over a power of r. Three sets are weighted with one hat function each, a single set with 1.
template <bool Taken, int Rank, int Sets>
struct Summed {
  Symmetric<Lanes, Rank> of[Sets];

  template <int Degree>
  [[gnu::always_inline]] void find(const FarCorner& corner, const Monomials<Degree>& m) {
    const auto all = [&](int i, int j) { return m.of[monomial_at(i, j)]; };
    if constexpr (Sets == 1) {
      of[0] = corner.tensor<Rank>(all);
    } else {
      of[1] = corner.tensor<Rank>([&](int i, int j) { return m.of[monomial_at(i + 1, j)]; });
      of[2] = corner.tensor<Rank>([&](int i, int j) { return m.of[monomial_at(i, j + 1)]; });
      of[0] = corner.tensor<Rank>([&](int i, int j) {
        return m.of[monomial_at(i, j)] - (m.of[monomial_at(i + 1, j)] + m.of[monomial_at(i, j + 1)]);
      });
    }
  }
};
template <int Rank, int Sets>
struct Summed<false, Rank, Sets> {
  template <int Degree>
  void find(const FarCorner&, const Monomials<Degree>&) {}
};

template <Layers L, int O>
struct FarMoments {
  template <int Rank, int Power>
  using Hats = Summed<takes_hats<L, O>(Rank, Power), Rank, 3>;
  template <int Rank, int Power>
  using Sums = Summed<takes_sums<L, O>(Rank, Power), Rank, 1>;

  // Named by rank and power.
  Hats<0, 1> hats01;
  Hats<0, 3> hats03;
  Hats<0, 4> hats04;
  Hats<0, 5> hats05;
  Hats<0, 6> hats06;
  Hats<1, 3> hats13;
  Hats<1, 5> hats15;
  Hats<1, 6> hats16;
  Hats<2, 5> hats25;
  Hats<2, 7> hats27;
  Hats<2, 8> hats28;
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

  /// \param corner from the point to corner 0 \param edges from there to corners 1 and 2 \param points those whose
  /// integrals are wanted; the others' are zero
  FarMoments(const FarRule& rule, const Three<Lanes>& corner, const double (&edges)[2][3], double area, Mask points) {
    // Squared lengths of the vectors from corner 0, of as many points at a time as a vector holds; those behind the
    // last have no weight.
    const double squares[3] = {dot_of(edges[0], edges[0]), 2 * dot_of(edges[0], edges[1]), dot_of(edges[1], edges[1])};
    static_assert(kPaddedNodes % kAtOnce == 0 && kPaddedNodes % kLanes == 0);
    alignas(64) double square_at[kPaddedNodes];
    for (int q = 0; q < rule.nodes; q += kLanes) {
      Lanes a, b;
      __builtin_memcpy(&a, rule.along[0] + q, sizeof a);
      __builtin_memcpy(&b, rule.along[1] + q, sizeof b);
      const Lanes square = a * (a * squares[0] + b * squares[1]) + b * b * squares[2];
      __builtin_memcpy(square_at + q, &square, sizeof square);
    }
    const Lanes first_square = dot(corner, corner), along = 2 * dot(edges[0], corner),
                across = 2 * dot(edges[1], corner);
    Over<-1> m;
    Over<1> m1;
    Over<3> m3;
    Over<4> m4;
    Over<5> m5;
    Over<6> m6;
    Over<7> m7;
    Over<8> m8;
    Over<9> m9;
    for (int first = 0; first < rule.nodes; first += kAtOnce) {
      Lanes r[kAtOnce], g[kAtOnce], g3[kAtOnce], g5[kAtOnce], g7[kAtOnce], g9[kAtOnce];
      Lanes g4[kAtOnce], g6[kAtOnce], g8[kAtOnce];
      for (int q = 0; q < kAtOnce; ++q) {
        const Lanes square = (first_square + square_at[first + q]) +
                             (along * rule.along[0][first + q] + across * rule.along[1][first + q]);
        if constexpr (L == Layers::MeanValue) {
          const Lanes g2 = reciprocal(square);
          g4[q] = g2 * g2;
          g6[q] = g4[q] * g2;
          g8[q] = g4[q] * g4[q];
        } else {
          g[q] = over_root(square);
          const Lanes g2 = g[q] * g[q];
          r[q] = square * g[q];
          g3[q] = g[q] * g2;
          g5[q] = g3[q] * g2;
          g7[q] = g5[q] * g2;
          g9[q] = g7[q] * g2;
        }
      }
      const double(*const weights)[kMostMonomials] = rule.monomial + first;
      if constexpr (L == Layers::MeanValue) {
        m4.add(g4, weights);
        m6.add(g6, weights);
        m8.add(g8, weights);
      } else {
        m.add(r, weights);
        m1.add(g, weights);
        m3.add(g3, weights);
        m5.add(g5, weights);
        m7.add(g7, weights);
        m9.add(g9, weights);
      }
    }
    const auto scale = [&](auto&... sums) { (sums.scale(area, points), ...); };
    scale(m, m1, m3, m4, m5, m6, m7, m8, m9);
    const FarCorner seen{corner, edges};
    const auto find = [&](const auto& from, auto&... to) { (to.find(seen, from), ...); };
    find(m, sum0);
    find(m1, hats01, sum01, sum11);
    find(m3, hats03, hats13, sum03, sum13, sum23);
    find(m4, hats04);
    find(m5, hats05, hats15, hats25, sum25, sum35);
    find(m6, hats06, hats16);
    find(m7, hats27, hats37, sum47);
    find(m8, hats28);
    find(m9, hats49);
  }

 private:
  template <int Power>
  using Over = Monomials<degree_over<L, O>(Power)>;

  static double dot_of(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
