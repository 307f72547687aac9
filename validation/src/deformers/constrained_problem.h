// SPDX-License-Identifier: MIT
// Input for a deformer without a posed cage. It consists of a cage, constraints drawn to known targets, and weights
// that scale with the cage's size.
#pragma once

#include "constrained_checks.h"

namespace cageproof::validation {

/// The name of the pose whose targets a rigid map has moved.
inline constexpr std::string_view rigid_pose = "rigid";
/// Weights, of a cage of size one: with beta so small, rigid targets are met to rounding within the steps that they are
/// given.
inline constexpr double of_jacobians = 1e-3, of_hessians = 1e-4;

/// A turn with a shift.
SpaceMap turn(int dimension);

/// Places of a method's constraints. All methods take positions; those that take more also get an orientation,
/// rotations, and enough Hessians to determine all coefficients.
std::vector<Vec3<double>> places_for(const deformation::ConstraintMethod& method, const Cage& cage, Triangulation rule);

/// A cage, and the constraints on its map.
struct ConstrainedProblem {
  Cage cage;
  deformation::Constraints constraints;
  double size;  ///< of the cage before it was turned, in the cage's unit

  std::shared_ptr<const deformation::ConstrainedDeformer<double>> prepared(const ConstrainedVariant& variant,
                                                                           Triangulation rule, int steps,
                                                                           double tolerance = 0) const;
  /// The same under a map of space, in a unit of length that is so many times smaller.
  ConstrainedProblem under(const SpaceMap& map, double length) const;
};

/// \param places of its constraints \param pose bent_pose or rigid_pose \throws InputError for another
ConstrainedProblem constrained_problem(const deformation::ConstraintMethod& method, const Cage& cage,
                                       const std::vector<Vec3<double>>& places, std::string_view pose,
                                       Triangulation rule);

}  // namespace cageproof::validation
