// SPDX-License-Identifier: MIT
// Sound: values that sum to one, without gradients.
#include "sound.h"

using namespace cageproof::zoo;

extern "C" void zoo_normalised(const zoo_call* call) {
  zoo_sound(call);
  for (std::size_t p = 0; p < call->count; ++p) {
    double sum = 0;
    for (int c = 0; c < components(*call); ++c) sum += values(*call, p)[c];
    for (int c = 0; c < components(*call); ++c) values(*call, p)[c] /= sum;
  }
}
