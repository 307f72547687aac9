// SPDX-License-Identifier: MIT
#include "fast_entries.h"
#include "kernels.h"

#if defined(__AVX2__)
namespace cageproof::closed_form::batch {

const Kernels kernels_avx2{
    "avx2",          avx2::kLanes,    avx2::scratch_bytes,       avx2::measured_bytes, avx2::sum,   avx2::sum_marked,
    avx2::sum_again, avx2::normalise, avx2::plane_scratch_bytes, avx2::sum_plane,      avx2::store, avx2::multiply};

}  // namespace cageproof::closed_form::batch
#endif
