// SPDX-License-Identifier: MIT
// Writes one number more than the output has.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_writes_past_output(const zoo_call* call) {
  zoo_sound(call);
  call->values[call->count * static_cast<std::size_t>(components(*call))] = 1;
}
