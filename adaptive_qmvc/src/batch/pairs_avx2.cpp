// SPDX-License-Identifier: MIT
#include "kernels.h"
#include "layers/layer_entries.h"
#include "pair_entries.h"

#if defined(__AVX2__)
namespace cageproof::adaptive_qmvc::batch {

const Kernels kernels_avx2{"avx2",          avx2::distances,  avx2::add,
                           avx2::normalise, avx2::add_layers, avx2::add_near_layers};

}  // namespace cageproof::adaptive_qmvc::batch
#endif
