// SPDX-License-Identifier: MIT
// Takes Poisson's ratio for its default, whatever is asked for.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_ignored_parameter(const zoo_call* call) {
  const std::array<double, 2> parameters{call->parameters[0], 0.3};
  zoo_call fixed = *call;
  fixed.parameters = parameters.data();
  zoo_sound(&fixed);
}
