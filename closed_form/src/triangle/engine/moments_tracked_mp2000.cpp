// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/engine/shared_instances.h"

namespace cageproof::closed_form::triangle {
CAGEPROOF_MOMENTS(, Tracked<Mp2000>)
}  // namespace cageproof::closed_form::triangle
