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

/// The systems of the true coordinates of a polygon, which are solved by least squares in more functions than
/// independent ones, so that their rank says nothing. It warns where they miss their data on the boundary.
inline DeformationReport report_on_true(const CageCoordinates& coordinates) {
  DeformationReport report{coordinates.solved(), {}, {}};
  constexpr double met = 1e-8;
  for (const SolvedSystem& system : report.systems)
    if (system.boundary_values > met)
      report.warnings.push_back(
          fmt::format("{}: the data on the boundary are met to {:.2g} only, and images inside are no better",
                      system.name, system.boundary_values));
  return report;
}

}  // namespace cageproof::deformation
