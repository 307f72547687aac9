// SPDX-License-Identifier: MIT
// The report on coordinates that are solved for on the boundary of a polygon.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/deformation/deformer.h"

#include <fmt/format.h>

namespace cageproof::deformation {

/// Above, roundings may cost images more than 1e-10 of their size. Stout polygons have 1e3 with 4 pieces per
/// edge, and 1e5 with 16.
inline constexpr double most_harmless = 5e5;

/// The systems that were solved for coordinates. It warns of singular ones, and names a way out ([W12]'s square system,
/// collocation=vertices, is singular for many a polygon), and of those that cost digits, as those of polygons with a
/// short edge, or with edges next to each other.
inline DeformationReport report_on(const CageCoordinates& coordinates) {
  DeformationReport report{coordinates.solved(), {}, {}};
  for (const SolvedSystem& system : report.systems)
    if (system.is_singular())
      report.warnings.push_back(
          fmt::format("{}: rank {} of {}, so that the solution of least norm is taken; more collocation points "
                      "determine it, as with collocation=vertices-and-midpoints",
                      system.name, system.rank, system.columns));
    else if (system.condition > most_harmless)
      report.warnings.push_back(fmt::format("{}: the condition is {:.1e}, and images may lose digits like it",
                                            system.name, system.condition));
  return report;
}

}  // namespace cageproof::deformation
