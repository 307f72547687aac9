// SPDX-License-Identifier: MIT
// Poisson's ratio next to 1/2, where bodies keep their volume.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace cageproof::deformation {

/// Tractions grow like one over 1 - 2 nu, and cancel in images.
inline void warn_of_pole(double nu, std::vector<std::string>& warnings) {
  const double off = std::abs(1 - 2 * nu);
  if (off <= 1e-6)
    warnings.push_back(
        fmt::format("nu is next to its pole 1/2: 1 - 2 nu = {:.1e}, and images lose digits like it", off));
}

}  // namespace cageproof::deformation
