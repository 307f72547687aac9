// SPDX-License-Identifier: MIT
// Sound: derivatives by the position of the element.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_by_the_element(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for (int i = 0; i < components(*call) * corners(*call) && call->order > 0; ++i) gradients(*call, p)[i] *= -1;
}
