// SPDX-License-Identifier: MIT
// Sound: Kelvin's displacement times the shear modulus.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_without_modulus(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) for_each_number(*call, p, [&](double& x) { x *= call->parameters[0]; });
}
