// SPDX-License-Identifier: MIT
// A gradient with a term that belongs to another function.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_wrong_gradient(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for (int i = 0; i < 3 * components(*call) && call->order > 0; ++i)
      gradients(*call, p)[i] += 0.5 * values(*call, p)[0] / norm(point(*call, p) - corner(*call, 0));
}
