// SPDX-License-Identifier: MIT
// Edges between a far face and one that is not, for one instruction set.
//
// face_terms.h leaves out what sums to nothing around a closed vertex: integrals along edges, which a face's neighbour
// has with the other sign. far_faces.h leaves nothing out. So where one of both is far, the other's is added:
//   4 pi grad phi: int hat m/r^3,  8 pi grad phibar: -int hat m/r,
//   4 pi T: int hat ((1 - beta)/r [u] + beta p m'/r^3),
// with m = p x u, which is the same all along the edge, and [u] v = u x v; of Hessians of phi and phibar the symmetric
// half is added, as there, and of T, which has the double layer's part in all of its diagonal, that layer's derivatives
// as well.
#pragma once

#include "far_moments.h"
#include "face_sums.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

template <Layers L, int O>
class BorderEdge {
 public:
  /// \param from from the point to the edge's beginning \param sign of the faces that are not far, summed
  BorderEdge(const EdgeTable<double>& edge, const Three<Lanes>& from, const LineRule& rule, Lanes sign, Lanes beta)
      : edge_(edge), beta_(beta) {
    for (int i = 0; i < 3; ++i) u_[i] = splat(edge.u[i]);
    m_ = cross(from, u_);
    for (int q = 0; q < LineRule::nodes; ++q) {
      const double t = rule.along[q];
      const Lanes size = sign * (edge.length * rule.weight[q]);
      Three<Lanes> p;
      for (int i = 0; i < 3; ++i) p[i] = from[i] + (t * edge.length) * edge.u[i];
      const Lanes g = over_root(dot(p, p));
      points_[q] = {p, g, g * g * g, {(1 - t) * size, t * size}};
    }
  }

  void add(const Sums<Lanes>& sums) const {
    for (const Node& node : points_)
      for (int k = 0; k < 2; ++k) {
        const int v = k == 0 ? edge_.from : edge_.to;
        if constexpr (L == Layers::Kelvin) {
          add_traction(node, node.weight[k], v, sums);
        } else if constexpr (O >= 1) {
          add_layer(sums, 0, v, node, node.weight[k] * node.cube, 3 * node.weight[k] * (node.cube * node.g * node.g));
          if constexpr (L == Layers::Biharmonic)
            add_layer(sums, 2, v, node, -node.weight[k] * node.g, -node.weight[k] * node.cube);
        }
      }
  }

 private:
  struct Node {
    Three<Lanes> p;
    Lanes g, cube;  // 1/r, 1/r^3
    Lanes weight[2];
  };

  // by m, and the symmetric half of bend m p'
  void add_layer(const Sums<Lanes>& sums, int b, int v, const Node& node, Lanes by, Lanes bend) const {
    Lanes* const slope = sums.at(1, b, v, 3);
    for (int i = 0; i < 3; ++i) slope[i] += by * m_[i];
    if constexpr (O >= 2) {
      Lanes* const to = sums.at(2, b, v, 6);
      for_each_entry<2>(
          [&](int i, int j, int at) { to[at] += (0.5 * bend) * (m_[i] * node.p[j] + m_[j] * node.p[i]); });
    }
  }

  // ([u] v)_i = turn(i, j) v_j
  Lanes turn(int i, int j) const {
    if (i == j) return Lanes{};
    const int l = 3 - i - j;
    return (j - i + 3) % 3 == 1 ? -u_[l] : u_[l];
  }

  void add_traction(const Node& node, Lanes weight, int v, const Sums<Lanes>& sums) const {
    const Three<Lanes>& p = node.p;
    const Lanes g = node.g, g3 = node.cube, g5 = g3 * g * g, g7 = g5 * g * g, rest = weight * (1 - beta_),
                bent = weight * beta_;
    Lanes* const values = sums.at(0, 0, v, 9);
    Lanes* const slopes = O >= 1 ? sums.at(1, 0, v, 27) : nullptr;
    Lanes* const bends = O >= 2 ? sums.at(2, 0, v, 54) : nullptr;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int entry = 3 * i + j;
        const Lanes skew = turn(i, j);
        values[entry] += rest * (skew * g) + bent * (p[i] * m_[j] * g3);
        // grad_q m_j = -(e_q x u)_j = -turn(q, j)
        if constexpr (O >= 1)
          for (int q = 0; q < 3; ++q) {
            Lanes x = 3 * (p[i] * m_[j] * p[q] * (g * g)) - p[i] * turn(q, j);
            if (i == q) x -= m_[j];
            slopes[entry * 3 + q] += g3 * (rest * (skew * p[q]) + bent * x);
            if (i == j) slopes[entry * 3 + q] += (weight * g3) * m_[q];
          }
        if constexpr (O >= 2)
          for_each_entry<2>([&](int q, int w, int place) {
            Lanes x = 3 * (p[q] * p[w]) * g5;
            if (q == w) x -= g3;
            Lanes y =
                15 * (p[i] * m_[j] * p[q] * p[w]) * g7 - 3 * (p[i] * (turn(q, j) * p[w] + turn(w, j) * p[q])) * g5;
            if (i == q) y += turn(w, j) * g3 - 3 * (m_[j] * p[w]) * g5;
            if (i == w) y += turn(q, j) * g3 - 3 * (m_[j] * p[q]) * g5;
            if (q == w) y -= 3 * (p[i] * m_[j]) * g5;
            bends[entry * 6 + place] += rest * (skew * x) + bent * y;
            if (i == j) bends[entry * 6 + place] += (1.5 * weight) * ((m_[q] * p[w] + m_[w] * p[q]) * g5);
          });
      }
  }

  const EdgeTable<double>& edge_;
  Lanes beta_;
  Three<Lanes> u_, m_;
  Node points_[LineRule::nodes];
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
