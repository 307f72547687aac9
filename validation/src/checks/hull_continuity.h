// SPDX-License-Identifier: MIT
// How quad weights change across the hull of a twisted quad, where the paper's projection is continuous only.
#pragma once

#include "cageproof/validation/measurement.h"
#include "cageproof/validation/regime.h"

#include <string>

namespace cageproof::validation {

/// The formula in results.
inline constexpr std::string_view hull_formula = "quad.mean_value";

/// Rows `hull_jump` of quad.mean_value for the evaluations that a glob names among closed_form and riemann-4: the jumps
/// of value (order 0) and of the numerical derivative along the normal (order 1) at points of the hulls of three
/// twisted quads, relative to the larger side.
Measurements hull_measurements(const std::string& evaluations, std::uint64_t seed);

}  // namespace cageproof::validation
