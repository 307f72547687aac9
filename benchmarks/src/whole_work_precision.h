// SPDX-License-Identifier: MIT
// Work-precision of kinds that are no sums of formulas, which can only be timed as a whole.
#pragma once

#include "cageproof/benchmarks/work_precision.h"

namespace cageproof::benchmarks {

/// As cage_work_precision says of such kinds. \pre the kind exists on the cage and is no sum
WorkPrecision whole_work_precision(const Cage& cage, const CoordinateKind& kind, const std::vector<PointGroup>& groups,
                                   const WorkPrecisionOptions& options);

}  // namespace cageproof::benchmarks
