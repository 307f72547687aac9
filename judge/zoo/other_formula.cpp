// SPDX-License-Identifier: MIT
// Sound: the double layer where the mean value was asked for.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_other_formula(const zoo_call* call) {
  zoo_call other = *call;
  other.formula = "triangle.double_layer";
  zoo_sound(&other);
}
