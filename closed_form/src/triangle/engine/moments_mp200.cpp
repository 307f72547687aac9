// SPDX-License-Identifier: MIT
#define CAGEPROOF_MOMENTS_HERE
#include "shared_instances.h"

namespace cageproof::closed_form::triangle {
CAGEPROOF_MOMENTS(, Mp200)
CAGEPROOF_FAR_MOMENTS(, Mp200)
}  // namespace cageproof::closed_form::triangle
