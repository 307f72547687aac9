// SPDX-License-Identifier: MIT
// Times of each kind of coordinates in one cage, for the report on that cage.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/results/run_result.h"

#include <vector>

namespace cageproof::benchmarks {

/// Least times of all coordinates of a point, values only, by the evaluation that commands take, for each kind that
/// accepts the cage: of some dozen points of the cage's box, together, on this thread. The kind's name stands where a
/// formula's does (EvaluationTime::formula). Kinds that solve on samples, which preparing takes too long for, are left
/// out. A few hundredths of a second each.
std::vector<EvaluationTime> times_of_kinds(const Cage& cage, Triangulation rule);

}  // namespace cageproof::benchmarks
