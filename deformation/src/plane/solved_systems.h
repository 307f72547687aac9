// SPDX-License-Identifier: MIT
// What there is to say of coordinates that are solved for on the boundary of a polygon.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace cageproof::deformation {

/// Warns of singular systems, and names a way out. [W12]'s square system, collocation=vertices, is singular for many a
/// polygon.
inline void warn_of_singular_systems(const std::vector<SolvedSystem>& systems, std::vector<std::string>& warnings) {
  for (const SolvedSystem& system : systems)
    if (system.is_singular())
      warnings.push_back(
          fmt::format("{}: rank {} of {}, so that the solution of least norm is taken; more collocation points "
                      "determine it, as with collocation=vertices-and-midpoints",
                      system.name, system.rank, system.columns));
}

}  // namespace cageproof::deformation
