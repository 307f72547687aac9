// SPDX-License-Identifier: MIT
#include "kernels.h"
#include "layers/layer_entries.h"
#include "pair_entries.h"

namespace cageproof::adaptive_qmvc::batch {

const Kernels kernels_plain{"plain",          plain::distances,  plain::add,
                            plain::normalise, plain::add_layers, plain::add_near_layers};

}  // namespace cageproof::adaptive_qmvc::batch
