// SPDX-License-Identifier: MIT
#include "multipoles.h"

#if defined(__AVX512F__)
namespace cageproof::closed_form::batch {

const ClusterKernels cluster_kernels_avx512{avx512::add_moments, avx512::sum_far_cluster};

}  // namespace cageproof::closed_form::batch
#endif
