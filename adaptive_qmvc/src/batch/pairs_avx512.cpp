// SPDX-License-Identifier: MIT
#include "kernels.h"
#include "layers/layer_entries.h"
#include "pair_entries.h"

#if defined(__AVX512F__)
namespace cageproof::adaptive_qmvc::batch {

const Kernels kernels_avx512{"avx512",          avx512::distances,  avx512::add,
                             avx512::normalise, avx512::add_layers, avx512::add_near_layers};

}  // namespace cageproof::adaptive_qmvc::batch
#endif
