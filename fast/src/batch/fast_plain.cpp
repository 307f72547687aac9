// SPDX-License-Identifier: MIT
#include "fast_entries.h"
#include "kernels.h"

namespace cageproof::closed_form::batch {

const Kernels kernels_plain{
    "plain",           plain::kLanes,    plain::scratch_bytes, plain::measured_bytes,      plain::sum,
    plain::sum_marked, plain::sum_again, plain::normalise,     plain::plane_scratch_bytes, plain::sum_plane,
    plain::store,      plain::multiply};

}  // namespace cageproof::closed_form::batch
