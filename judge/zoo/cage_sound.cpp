// SPDX-License-Identifier: MIT
// Sound: mean value coordinates.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_cage_sound(const zoo_cage* cage) { zoo_mean_value(cage, nullptr); }
