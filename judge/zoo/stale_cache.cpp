// SPDX-License-Identifier: MIT
// Keeps what it has computed of an element by the address of its corners.
#include "sound.h"

#include <vector>

using namespace cageproof::zoo;

extern "C" void zoo_stale_cache(const zoo_call* call) {
  static const double* known = nullptr;
  static std::vector<double> kept;
  if (call->corners != known) kept.assign(call->corners, call->corners + 3 * corners(*call));
  known = call->corners;
  zoo_call with_kept = *call;
  with_kept.corners = kept.data();
  zoo_sound(&with_kept);
}
