// SPDX-License-Identifier: MIT
#include "kernels.h"
#include "pair_entries.h"

namespace cageproof::adaptive_qmvc::batch {

const Kernels kernels_plain{"plain", plain::distances, plain::add, plain::normalise};

}  // namespace cageproof::adaptive_qmvc::batch
