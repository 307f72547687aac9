// SPDX-License-Identifier: MIT
// The innermost loops of a fixed rule over a cage's triangles, on vectors of points, and written plainly. Plain data
// only: their source is compiled for several instruction sets, and must not share inline functions with the program.
#pragma once

namespace cageproof::benchmarks {

/// Points a vector. AVX-512 holds them in one register, AVX2 in two, SSE2 in four.
inline constexpr int gauss_lanes = 8;

/// Which kernels are summed.
enum class GaussKernels { Green, Biharmonic, Somigliana };

/// Count of one node's weights, each its weight w times hat functions. Green and biharmonic have w G_0, w G_1, w G_2,
/// w. Somigliana has w, then the six w G_k G_l with k <= l, then the ten w G_k G_l G_m with k <= l <= m.
constexpr int gauss_weights(GaussKernels kernels) { return kernels == GaussKernels::Somigliana ? 17 : 4; }

/// A rule: `count` nodes.
struct GaussNodes {
  int count;
  const double* hats;     ///< [node][3]
  const double* plain;    ///< [node]: weights, which sum to one half
  const double* weights;  ///< [node][gauss_weights]
};

/// A triangle, and the coordinates that it has shares in.
struct GaussTriangle {
  double corners[3][3];
  double normal[3];  ///< unit, outward
  double twice_area;
  int vertices[3];
  int number;
};

/// The work of one call: all coordinates at a block of points.
struct GaussTask {
  GaussKernels kernels;
  GaussNodes nodes;
  const GaussTriangle* triangles;
  int triangle_count, vertex_count;
  double shear, poisson;  ///< of Somigliana's: mu and nu
  int points;             ///< on vectors a multiple of gauss_lanes
  const double* eta;      ///< on vectors [vector][3][lane], plainly [point][3]
  /// Zero at first; phi, psi, phibar, psibar or T, K one after the other: [coordinate][entry], on vectors
  /// [vector][coordinate][entry][lane], plainly [point][coordinate][entry].
  double* sums;
  double* positions;  ///< memory for three numbers per node
};

/// Numbers a point.
int gauss_entries(const GaussTask& task);

/// By the widest vectors that this processor has: AVX-512, AVX2 with FMA, or what the compiler may use anywhere.
void gauss_on_vectors(const GaussTask& task);

/// One point, one triangle, one node after the other, kernels as the papers print them.
void gauss_plainly(const GaussTask& task);

}  // namespace cageproof::benchmarks
