// SPDX-License-Identifier: MIT
#include "sums.h"

namespace cageproof::closed_form::triangle {

const PanelSum panel_sum_plain = CAGEPROOF_SIMD::sum_panel;

}  // namespace cageproof::closed_form::triangle
