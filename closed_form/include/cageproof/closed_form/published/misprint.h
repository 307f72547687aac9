// SPDX-License-Identifier: MIT
// Which misprint of [T24], or of [W12] in the plane, an evaluation keeps.
#pragma once

#include <array>
#include <string_view>

namespace cageproof::closed_form::published {

/// None: every equation after the errata. The others keep the paper's printed form at one place; errata.h names it.
enum class Misprint { None, AppendixA, Equation18, Equation48, Equation49, AppendixC };

/// The evaluation's name: "published", or "as-printed-" and the place.
constexpr std::string_view evaluation_name(Misprint misprint) {
  constexpr std::array<std::string_view, 6> names{"published",       "as-printed-appendix-a", "as-printed-eq18",
                                                  "as-printed-eq48", "as-printed-eq49",       "as-printed-appendix-c"};
  return names[static_cast<std::size_t>(misprint)];
}

}  // namespace cageproof::closed_form::published
