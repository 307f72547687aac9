// SPDX-License-Identifier: MIT
// The report on coordinates that are solved for on the boundary of a polygon.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace cageproof::deformation {

/// Above, roundings may cost images more than 1e-10 of their size. Stout polygons have 1e3 with 4 pieces per
/// edge, and 1e5 with 16.
inline constexpr double most_harmless = 5e5;

/// Warns of singular systems, and names a way out ([W12]'s square system, collocation=vertices, is singular for many a
/// polygon), and of those that cost digits, as those of polygons with a short edge, or with edges next to each other.
inline void warn_of_singular_systems(const std::vector<SolvedSystem>& systems, std::vector<std::string>& warnings) {
  for (const SolvedSystem& system : systems)
    if (system.is_singular())
      warnings.push_back(
          fmt::format("{}: rank {} of {}, so that the solution of least norm is taken; more collocation points "
                      "determine it, as with collocation=vertices-and-midpoints",
                      system.name, system.rank, system.columns));
    else if (system.condition > most_harmless)
      warnings.push_back(fmt::format("{}: the condition is {:.1e}, and images may lose digits like it", system.name,
                                     system.condition));
}

}  // namespace cageproof::deformation
