// SPDX-License-Identifier: MIT
// A summary of coordinates as text.
#pragma once

#include "cageproof/validation/coordinate_summary.h"

#include <string>
#include <vector>

namespace cageproof::cli {

/// Lines for a user with counts, residuals, and a warning for each kind of points that a mesh cannot be deformed at.
std::vector<std::string> lines_of(const validation::CoordinateSummary& summary, const CoordinateKind& kind,
                                  const Cage& cage);

}  // namespace cageproof::cli
