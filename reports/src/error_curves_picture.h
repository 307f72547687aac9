// SPDX-License-Identifier: MIT
// Largest error over the parameter that a regime sweeps, one line per evaluation.
#pragma once

#include "cageproof/core/results/work_precision.h"
#include "gnuplot.h"

namespace cageproof::reports {

/// One picture per sweep, "pictures/error_<sweep>.png", both axes logarithmic. Errors of zero are drawn at the lower
/// edge, what is not finite at the upper one. None where nothing is swept.
std::vector<Picture> error_curves_pictures(const WorkPrecision& result);

}  // namespace cageproof::reports
