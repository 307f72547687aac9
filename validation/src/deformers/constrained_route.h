// SPDX-License-Identifier: MIT
// Whether maps by constraints are what their energies say: stationary, by differences of energies that are written
// another time (second_routes).
#pragma once

#include "deformers/constrained_problem.h"

namespace cageproof::validation {

/// The larger of two ratios: the slope left over an earlier one, and the error of the energy in the map's report over
/// the energy found here. For `variational` the slope is the gradient in all coefficients after a global step, over
/// that of the identity, with the rotations nearest to the Jacobians of the step before. For `thickness` it is the
/// gradient along poses that meet the constraints, over the whole; the constraints' error in cage sizes counts as well.
double unmet_stationarity(const ConstrainedProblem& problem, const ConstrainedVariant& variant, Triangulation rule);

}  // namespace cageproof::validation
