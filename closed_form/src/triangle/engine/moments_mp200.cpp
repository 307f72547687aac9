// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/engine/shared_instances.h"

namespace cageproof::closed_form::triangle {
CAGEPROOF_MOMENTS(, Mp200)
CAGEPROOF_FAR_MOMENTS(, Mp200)
}  // namespace cageproof::closed_form::triangle
