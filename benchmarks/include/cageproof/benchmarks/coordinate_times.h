// SPDX-License-Identifier: MIT
// [T18] Table 1 with the errors that it lacks: whole coordinates of a mesh in a cage, by kind and evaluation.
#pragma once

#include "cageproof/benchmarks/work_precision.h"

#include <utility>

namespace cageproof::benchmarks {

/// A kind of coordinates and the evaluation of its formulas; empty for the recommended ones.
using KindAndEvaluation = std::pair<std::string, std::string>;

/// Table 1's: mean value coordinates of the triangulated cage, recommended and as printed, quad mean value coordinates
/// by the paper's scheme (n = 4, 7, 10), by tessellation and by the line form, spherical mean value and maximum entropy
/// coordinates.
std::vector<KindAndEvaluation> table_one();

/// Time of all coordinates at a point, on one thread, over points spread evenly for a second or options.seconds,
/// whichever is longer; and at `options.samples` of the points, evenly spread, the largest difference of a coordinate
/// from the quad mean value coordinates by the line form in 50 digits. For other kinds that difference is no error,
/// only how much they differ. \throws InputError for an unknown kind or evaluation, or without points
WorkPrecision coordinate_times(const Cage& cage, const std::vector<Vec3<double>>& points,
                               const std::vector<KindAndEvaluation>& what, const WorkPrecisionOptions& options);

}  // namespace cageproof::benchmarks
