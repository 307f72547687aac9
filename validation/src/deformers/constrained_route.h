// SPDX-License-Identifier: MIT
// Whether maps by constraints are what their energies say: stationary, by differences of energies that are written
// another time (second_routes).
#pragma once

#include "deformers/constrained_problem.h"

namespace cageproof::validation {

/// The larger of two: the slope that is left, over one that there was, and how far the energy that the map's report
/// states is from the one found here, over it. Of `variational`: the gradient in all coefficients after a global step,
/// over that of the identity, with the rotations nearest to the Jacobians of the step before. Of `thickness`: the
/// gradient along poses that meet the constraints, over the whole, and how far these are missed, in cage sizes.
double unmet_stationarity(const ConstrainedProblem& problem, const ConstrainedVariant& variant, Triangulation rule);

}  // namespace cageproof::validation
