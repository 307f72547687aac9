// SPDX-License-Identifier: MIT
#include "multipoles.h"

namespace cageproof::closed_form::batch {

const ClusterKernels cluster_kernels_plain{plain::add_moments, plain::sum_far_cluster};

}  // namespace cageproof::closed_form::batch
