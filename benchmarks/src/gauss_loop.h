// SPDX-License-Identifier: MIT
// Whole coordinates by a fixed rule on every triangle, as quick as such a loop gets: closed forms have to beat it.
#pragma once

#include "gauss_kernels.h"

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::benchmarks {

/// Nodes and weights on the triangle of corners (1, 0, 0), (0, 1, 0), (0, 0, 1) in hat functions; weights sum to 1/2.
struct GaussRule {
  std::string name;
  std::vector<double> hats;     ///< [node][3]
  std::vector<double> weights;  ///< [node]
};

/// `gauss-<N>`: Gauss-Legendre on the collapsed square, N points per side.
GaussRule collapsed_rule(int side);

/// `three-quad-<3 N^2>`: Gauss-Legendre on three quads, N points per side, [C23] Section 5; N = 50 is its yardstick of
/// 7500 points.
GaussRule three_quad_rule(int side);

/// Values of green, biharmonic or somigliana coordinates by a rule. Safe from any thread.
class GaussLoop {
 public:
  /// Whether the loop exists for the kind: in space, for three kinds.
  static bool exists(const CoordinateKind& kind, const Cage& cage);

  /// Quads are split at their shorter diagonal, parameters are the kind's defaults. \pre exists(kind, cage)
  GaussLoop(const Cage& cage, const CoordinateKind& kind, const GaussRule& rule);

  const CageElements& elements() const { return elements_; }
  /// Numbers of all coordinates of a point.
  std::size_t entries() const;

  /// All blocks of a point one after the other, [point][coordinate][entry], on vectors of points. \param values of
  /// points.size() * entries() numbers
  void fill_on_vectors(std::span<const Vec3<double>> points, std::span<double> values) const;
  /// The same, written plainly: point by point, triangle by triangle, node by node.
  void fill_plainly(std::span<const Vec3<double>> points, std::span<double> values) const;

 private:
  GaussTask task() const;

  CageElements elements_;
  std::vector<GaussTriangle> triangles_;
  std::vector<double> hats_, plain_, weights_;
  GaussKernels kernels_;
  std::vector<double> parameters_;
};

}  // namespace cageproof::benchmarks
