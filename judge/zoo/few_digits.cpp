// SPDX-License-Identifier: MIT
// Goes through single precision on the way.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_few_digits(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p)
    for_each_number(*call, p, [](double& x) { x = static_cast<double>(static_cast<float>(x)); });
}
