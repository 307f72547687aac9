// SPDX-License-Identifier: MIT
// The rigid motion next to what constraints ask for, from which maps by constraints are found.
#pragma once

#include "nearest_rotation.h"

#include "cageproof/deformation/constrained.h"

namespace cageproof::deformation {

/// x -> turn (x - from) + to. Both places are doubles next to the points, so that steps from them are hardly rounded.
template <Scalar R>
struct Motion {
  SpaceMatrix<R> turn;
  Vec3<double> from, to;

  /// One row per point, as seen from `from` before the motion, from `to` after it.
  Matrix<R> turned(const Matrix<R>& rows) const { return rows * turn.transpose(); }
  Matrix<R> turned_back(const Matrix<R>& rows) const { return rows * turn; }
};

/// The motion for which sum |turn (at - from) + to - target|^2 over positions, plus the square of the size times sum
/// |turn - jacobian|^2 over orientations, is least. Where these leave turns free, the least of them.
/// \param targets of the positions \param from any place next to the cage
template <Scalar R>
Motion<R> nearest_motion(const Constraints& constraints, const std::vector<Vec3<double>>& targets,
                         const Vec3<double>& from, double size, int dimension);

}  // namespace cageproof::deformation
