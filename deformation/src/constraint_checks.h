// SPDX-License-Identifier: MIT
// Constraints as they are given: that their numbers are finite and their places inside, and where positions go.
#pragma once

#include "cageproof/deformation/constrained.h"

#include <string>

namespace cageproof::deformation {

/// \param name of the constraint in messages \throws ConstraintError unless the first `dimension` coordinates are
/// finite
void check_finite(const std::string& name, const Vec3<double>& point, int dimension);

/// Inside, and on the cage seen from inside, coordinates of vertices sum to one; outside to zero.
/// \param name of the constraints in messages \param of_vertices their table at the points, values
/// \throws ConstraintError for a point outside
template <Scalar R>
void check_inside(const std::string& name, const std::vector<Vec3<double>>& points,
                  const CoordinateTable<R>& of_vertices, int dimension);

/// A point as messages say it.
std::string place_text(const Vec3<double>& point, int dimension);

/// Where the positional constraints go, in their order.
std::vector<Vec3<double>> targets_of(const Constraints& constraints);

/// \throws ConstraintError unless there are as many targets as positional constraints, all finite
void check_targets(const std::vector<Vec3<double>>& targets, const Constraints& constraints, int dimension);

}  // namespace cageproof::deformation
