// SPDX-License-Identifier: MIT
#include "sums.h"

#if defined(__AVX512F__)
namespace cageproof::fast::triangle {

const PanelSum panel_sum_avx512 = avx512::sum_panel;

}  // namespace cageproof::fast::triangle
#endif
