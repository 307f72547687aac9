// SPDX-License-Identifier: MIT
// Times of evaluations, shown next to their errors in the report of a verification.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>
#include <vector>

namespace cageproof::benchmarks {

/// Median times of the standard evaluations in double whose formula and name match these globs, for value, gradient and
/// Hessian: of a few dozen pairs of the regime `generic`, always the same ones, on this thread. Evaluations that take
/// milliseconds, in multiprecision, are left out. A second or two for the whole catalogue.
std::vector<EvaluationTime> times_of_evaluations(const std::string& formulas, const std::string& evaluations);

}  // namespace cageproof::benchmarks
