// SPDX-License-Identifier: MIT
// Functions for layers that the sources of each instruction set define.
#pragma once

#include "far_layers.h"
#include "near_layers.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

inline void add_layers(const LayerPairs& to) {
  const bool biharmonic = to.biharmonic.double_layer != nullptr;
  if (to.close && biharmonic) add_layers_of<true>(to, CloseLines{});
  else if (to.close) add_layers_of<false>(to, CloseLines{});
  else if (biharmonic) add_layers_of<true>(to, DistantLines{});
  else add_layers_of<false>(to, DistantLines{});
}

inline void add_near_layers(const NearLines& lines, double* to) {
  if (lines.biharmonic) add_near_layers_of<true>(lines, to);
  else add_near_layers_of<false>(lines, to);
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
