// SPDX-License-Identifier: MIT
// Kelvin's layers ([C23] Eq 3, 4 and 8 in space) on the triangles of a cage, and on their pieces.
#pragma once

#include "elastic_layers.h"

#include "../boundary_in_space/surface_layer.h"

namespace cageproof::solved {

/// The cage's triangles, whole and in pieces.
struct ElasticSurface {
  RefinedSurface pieces, whole;

  /// \throws InputError where pieces are too many
  ElasticSurface(const Cage& cage, const CageElements& elements, int level);

  /// A piece's unknowns, a traction's components.
  static constexpr int densities = 3;
  int unknowns() const { return densities * pieces.pieces(); }
};

/// The places at which the boundary's equation is asked to hold: the centroid of each piece, rounded to double, so
/// that places are the same in every scalar.
std::vector<PlaceOnTriangle> centroids(const RefinedSurface& surface);

/// K of tractions that are constant on pieces, and T of displacements that are affine on triangles.
template <Scalar R>
class ElasticSurfaceLayers {
 public:
  /// Keeps references. \param nu Poisson's ratio; the shear modulus is one \param vertices of the cage
  ElasticSurfaceLayers(const ElasticSurface& surface, const ElasticEvaluations& evaluations, double nu, int vertices);

  /// K: a 3 x 3 matrix per piece.
  const SurfaceLayer<R>& displacement() const { return displacement_; }

  /// T's limit from inside, a 3 x 3 matrix per vertex: [vertex][row][column][derivatives].
  CoordinateTable<R> traction_limit(const PlaceOnTriangle& place, int order) const;

 private:
  const ElasticSurface& surface_;
  SurfaceLayer<R> displacement_, traction_;
  std::size_t vertices_;
};

}  // namespace cageproof::solved
