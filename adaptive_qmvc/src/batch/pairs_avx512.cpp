// SPDX-License-Identifier: MIT
#include "kernels.h"
#include "pair_entries.h"

#if defined(__AVX512F__)
namespace cageproof::adaptive_qmvc::batch {

const Kernels kernels_avx512{"avx512", avx512::distances, avx512::add, avx512::normalise};

}  // namespace cageproof::adaptive_qmvc::batch
#endif
