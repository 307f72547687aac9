// SPDX-License-Identifier: MIT
// Functions for layers that the sources of each instruction set define.
#pragma once

#include "far_layers.h"
#include "near_layers.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

inline void add_layers(const LayerPairs& to) {
  if (to.close) add_layers_of(to, CloseLines{});
  else add_layers_of(to, DistantLines{});
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
