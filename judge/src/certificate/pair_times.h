// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/judge/element_campaign.h"

namespace cageproof::judge {

/// Times of foreign code, by name, and of this project's plain and recommended evaluations on the same blocks, at the
/// highest order and for values only. Those that the code cannot give are left out.
std::vector<PairTime> pair_times(ForeignCode& code, const Request& request, const std::string& name);

}  // namespace cageproof::judge
