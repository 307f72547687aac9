// SPDX-License-Identifier: MIT
// Samples on a cage, and the layers there.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// Points of the cage. Each element is split `level` times by its midpoints, and the parts' centroids are taken; on a
/// quad, the points amid the parts of u and v. They are 4^level points per triangle or quad, strictly within it, in its
/// basis functions, which sum to one: multiples of 2^-52, the same whichever corner an element begins with.
std::vector<Touching> samples_of(const CageElements& elements, int level);

/// Values of basis functions and layers at samples, one row per sample; limits from inside. Lengths are in a unit of
/// the cage's own, so that their powers, and those of solutions, stay in range.
template <Scalar R>
struct SampledLayers {
  double unit = 1;  ///< the power of two next to the cage's size, in the user's unit
  double size = 1;  ///< of the cage, in that unit
  std::vector<Touching> samples;
  Matrix<R> hats;  ///< of vertices: M
  Matrix<R> phi, psi, phibar,
      psibar;         ///< one column per vertex, or per element; on kept quads per normal (Owner::Normal)
  Matrix<R> neumann;  ///< the factor of normal derivatives: psi, or one column per corner
};

/// Limits of the layers and their derivatives up to an order. Those of phi sum to one, and their derivatives to
/// nothing, whatever the cage: what does not is no limit. \pre the coordinates are of kind `biharmonic`,
/// `biharmonic_affine` or `quad_biharmonic` \throws InputError for an evaluation that has no limits on the cage
template <Scalar R>
std::vector<CoordinateTable<R>> checked_limits(const CageCoordinates& coordinates, std::span<const Touching> samples,
                                               int order);

/// \throws InputError as checked_limits, and for more samples than memory holds
template <Scalar R>
SampledLayers<R> layers_at(const CageCoordinates& coordinates, int level);

/// One component of a block's derivatives of one order at samples, one row per sample.
template <Scalar R>
Matrix<R> component(const CoordinateTable<R>& table, std::size_t samples, int order, std::size_t width,
                    std::size_t which) {
  const std::size_t count = table.stride[order] / width;
  Matrix<R> found(static_cast<Eigen::Index>(samples), static_cast<Eigen::Index>(count));
  for (std::size_t s = 0; s < samples; ++s)
    for (std::size_t i = 0; i < count; ++i)
      found(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(i)) =
          table.tensors[order][s * table.stride[order] + i * width + which];
  return found;
}

}  // namespace cageproof::deformation
