// SPDX-License-Identifier: MIT
#include "sums.h"

#if defined(__AVX512F__)
namespace cageproof::closed_form::triangle {

const PanelSum panel_sum_avx512 = avx512::sum_panel;

}  // namespace cageproof::closed_form::triangle
#endif
