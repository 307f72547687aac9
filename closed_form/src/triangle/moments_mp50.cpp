// SPDX-License-Identifier: MIT
#define CAGEPROOF_MOMENTS_HERE
#include "shared_instances.h"

namespace cageproof::closed_form {
CAGEPROOF_MOMENTS(, Mp50)
}  // namespace cageproof::closed_form
