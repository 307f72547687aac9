// SPDX-License-Identifier: MIT
#include "sums.h"

#if defined(__AVX2__)
namespace cageproof::fast::triangle {

const PanelSum panel_sum_avx2 = avx2::sum_panel;

}  // namespace cageproof::fast::triangle
#endif
