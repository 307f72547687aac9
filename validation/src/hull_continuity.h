// SPDX-License-Identifier: MIT
// How quad weights change across the hull of a twisted quad, where the paper's projection is continuous only.
#pragma once

#include "cageproof/core/run_result.h"

#include <string>
#include <vector>

namespace cageproof::validation {

/// The regime's name in results.
inline constexpr std::string_view hull_regime = "hull";

/// Rows `hull_jump` of quad.mean_value for the evaluations that a glob names among closed_form and riemann-4: the largest jump of value (order 0) and of the
/// numerical derivative along the normal (order 1) over points of the hulls of three twisted quads, relative to the larger side.
std::vector<ResultRow> run_hull_continuity(const std::string& evaluations, std::uint64_t seed);

}  // namespace cageproof::validation
