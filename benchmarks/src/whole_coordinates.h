// SPDX-License-Identifier: MIT
// Whole coordinates for benchmarks: the evaluations that compute them, and the data that they are applied to.
#pragma once

#include "deformer_benchmarks.h"

#include "cageproof/core/coordinates/whole_evaluation.h"

namespace cageproof::benchmarks {

/// The evaluations that a kind is timed by in a cage: whole ones (whole_evaluations) that compute it, the formulas'
/// recommended one, and of kinds that keep quads their schemes and direct rules.
struct TimedEvaluation {
  std::string name;
  bool whole;
};
std::vector<TimedEvaluation> timed_evaluations(const CoordinateKind& kind, const Cage& cage);

/// Blocks of data that a pose of the cage gives. They are deformed vertices, normals of deformed elements times the
/// root of the ratio of areas, and a tenth of these for blocks that reproduce nothing. Coordinates that are numbers
/// have one set per coordinate of space (three, in the plane two), matrices have one set.
CageData data_of_pose(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& posed);

}  // namespace cageproof::benchmarks
