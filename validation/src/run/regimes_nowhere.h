// SPDX-License-Identifier: MIT
// Regimes that are asked for by name and that elements do not have: nothing is measured there.
#pragma once

#include <string>
#include <string_view>

namespace cageproof::validation {

/// "near-edge is no regime of segments: nothing was asked there."; empty where all regimes that are named exist for the
/// elements of all formulas that are. A glob names no regime, and `*` no formula.
std::string regimes_nowhere(std::string_view formulas, std::string_view regimes);

}  // namespace cageproof::validation
