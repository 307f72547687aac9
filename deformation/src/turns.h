// SPDX-License-Identifier: MIT
// How a pose turns and stretches vertices, and elements where their normals are ([C23] Section 4.2).
#pragma once

#include "in_space.h"

#include "cageproof/deformation/deformer.h"

#include <functional>

namespace cageproof::deformation {

template <Scalar R>
std::vector<Vec3<R>> over(std::vector<Vec3<R>> points, const R& unit) {
  for (Vec3<R>& p : points) p /= unit;
  return points;
}

/// Where a normal (Owner::Normal) is.
struct NormalPlace {
  std::size_t element;
  int corner;  ///< of a quad; 0 of flat elements
};

/// All of them, in the order of their numbers.
std::vector<NormalPlace> normal_places(const CageElements& elements);

/// The integral of an element's area vector where vertices are elsewhere, a segment's being as long as it; of a quad
/// with the corner's basis function for u and v, and the normal there: N_k/4, which add up to the whole.
template <Scalar R>
Vec3<R> area_vector(const CageElements& rest, const std::vector<Vec3<R>>& vertices, const NormalPlace& place);

/// One rotation per vertex and normal, and one stretch per normal.
template <Scalar R>
struct Turns {
  std::vector<SpaceMatrix<R>> of_vertices, of_normals;
  std::vector<R> stretches;
};

/// Turns of one similarity for all (blend 0), or of each normal's element there and, nearest to the sum around it
/// weighted with areas, of each vertex (blend 1), or between these. \param from, posed in a unit of about the cage's
/// size
/// \param stretches of normals, asked for where they are needed \param warnings takes rotations that are not unique
template <Scalar R>
Turns<R> turns_of(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                  const std::function<std::vector<R>()>& stretches, double blend, std::vector<std::string>& warnings);

/// Only the turns of vertices, for a blend of one. \throws InputError for an element without a normal
template <Scalar R>
std::vector<SpaceMatrix<R>> vertex_rotations(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                                             std::vector<std::string>& warnings);

}  // namespace cageproof::deformation
