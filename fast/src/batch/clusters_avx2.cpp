// SPDX-License-Identifier: MIT
#include "multipoles.h"

#if defined(__AVX2__)
namespace cageproof::closed_form::batch {

const ClusterKernels cluster_kernels_avx2{avx2::add_moments, avx2::sum_far_cluster};

}  // namespace cageproof::closed_form::batch
#endif
