// SPDX-License-Identifier: MIT
#include "fast_entries.h"
#include "kernels.h"

#if defined(__AVX512F__)
namespace cageproof::closed_form::batch {

const Kernels kernels_avx512{
    "avx512",           avx512::kLanes,    avx512::scratch_bytes, avx512::measured_bytes,      avx512::sum,
    avx512::sum_marked, avx512::sum_again, avx512::normalise,     avx512::plane_scratch_bytes, avx512::sum_plane,
    avx512::store,      avx512::multiply};

}  // namespace cageproof::closed_form::batch
#endif
