// SPDX-License-Identifier: MIT
#define CAGEPROOF_MOMENTS_HERE
#include "shared_instances.h"

namespace cageproof::closed_form {
CAGEPROOF_MOMENTS(, Tracked<TwoDoubles>)
}  // namespace cageproof::closed_form
