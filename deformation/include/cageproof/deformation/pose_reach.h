// SPDX-License-Identifier: MIT
// Bounds on the vectors that coordinates multiply, over all poses whose vertices move by at most a given length.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <string>
#include <vector>

namespace cageproof::deformation {

/// The vectors that one coordinate multiplies: those within `radius` of `centre`, in the cage's unit of length.
/// Coordinates of one `group` multiply places, which a translation of the cage moves together; -1: directions.
struct PoseReach {
  Vec3<double> centre;
  double radius;
  int group;
};

/// One for each coordinate of a row, block after block. Of vertices (turned by a quarter, too) all places within
/// `moved` of that at rest. Of normals n all vectors s n', posed unit normals n' that are as long as any of
/// stretch_names() says: the map from an element to the posed one, of Frobenius norm sqrt 2 at rest, changes by sum u_k
/// g_k' where corners move by u_k, g_k the gradients of hat functions, so by no more, in that norm, than
///     rho = moved min(sum |g_k|, sqrt 3 sigma), sigma the largest singular value of the gradients' matrix
/// (2 moved/length of segments). So s <= 1 + rho / sqrt 2, and |s n' - n| <= 2 + rho / sqrt 2. Where rho < 1, singular
/// values are within rho of one, and of a unit vector's image the part along n, a, and the change within the element's
/// plane, b, have a^2 + b^2 <= rho^2: it rises by a/(1 - b), the sine of which angle is rho at most, and n' turns by no
/// more. So |s n' - n|^2 = (s - 1)^2 + s |n' - n|^2 <= rho^2 + (1 + rho) 2 rho^2 / (1 + sqrt(1 - rho^2)).
/// Infinite of elements whose area is lost in rounding. \param moved at least 0 \param size the cage's
/// \throws InputError naming the block for kinds that multiply something else (why_without_reach)
std::vector<PoseReach> pose_reach(const CageCoordinates& coordinates, double moved, double size);

/// Why nothing bounds what a kind's coordinates multiply, the first reason; empty where something does: each block has
/// one number per vertex, or one per flat element, and multiplies posed vertices or stretched normals.
std::string why_without_reach(const CageCoordinates& coordinates);

/// The kinds, with their parameters' defaults, that have bounds in cages of that dimension, 2 or 3.
std::vector<std::string_view> kinds_with_reach(int dimension);

}  // namespace cageproof::deformation
