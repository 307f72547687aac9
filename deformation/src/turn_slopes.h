// SPDX-License-Identifier: MIT
// The derivatives of a pose's rotations by posed vertices.
#pragma once

#include "row_slopes.h"
#include "turns.h"

namespace cageproof::deformation {

/// Rotations Q, and rows of their derivatives as rotation vectors theta: dQ = [theta]x Q.
template <Scalar R>
struct TurnSlopes {
  std::vector<Mat3<R>> rotations;
  RowSlopes<R> slopes;
};

/// Returns the slopes of turns_of() with a blend of one, of each normal's element there, or of each vertex.
/// \param from, posed in a unit of about the cage's size, by which the slopes are
/// \throws InputError for an element without a normal, and where a rotation is not unique
template <Scalar R>
TurnSlopes<R> normal_turn_slopes(const CageElements& rest, const std::vector<Vec3<R>>& from,
                                 const std::vector<Vec3<R>>& posed);
/// \param of_normals normal_turn_slopes of the same pose
template <Scalar R>
TurnSlopes<R> vertex_turn_slopes(const CageElements& rest, const std::vector<Vec3<R>>& from,
                                 const TurnSlopes<R>& of_normals);

/// [v]x, which takes w to v x w.
template <Scalar R>
Mat3<R> cross_matrix(const Vec3<R>& v) {
  Mat3<R> found;
  found << R(0), -v[2], v[1], v[2], R(0), -v[0], -v[1], v[0], R(0);
  return found;
}

}  // namespace cageproof::deformation
