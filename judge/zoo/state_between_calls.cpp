// SPDX-License-Identifier: MIT
// Keeps the first element's corners for all that follow.
#include "sound.h"

#include <vector>

using namespace cageproof::zoo;

extern "C" void zoo_state_between_calls(const zoo_call* call) {
  static std::vector<double> first(call->corners, call->corners + 3 * corners(*call));
  zoo_call kept = *call;
  kept.corners = first.data();
  zoo_sound(&kept);
}
