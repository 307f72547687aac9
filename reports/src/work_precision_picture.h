// SPDX-License-Identifier: MIT
// Largest error against nodes and against time, both axes logarithmic.
#pragma once

#include "cageproof/core/results/work_precision.h"
#include "gnuplot.h"

namespace cageproof::reports {

/// One colour a place; rules of one family ("three-quad-<P>") are joined by a line, each evaluation is a labelled
/// point. Against nodes, evaluations without any are level dashed lines.
enum class WorkAxis { Nodes, Time };
Picture work_precision_picture(const WorkPrecision& result, WorkAxis axis, std::string file);

}  // namespace cageproof::reports
