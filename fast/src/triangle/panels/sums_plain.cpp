// SPDX-License-Identifier: MIT
#include "sums.h"

namespace cageproof::fast::triangle {

const PanelSum panel_sum_plain = CAGEPROOF_SIMD::sum_panel;

}  // namespace cageproof::fast::triangle
