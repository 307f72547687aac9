// SPDX-License-Identifier: MIT
#include "instances.h"

namespace cageproof::closed_form::published {

CAGEPROOF_PUBLISHED_SCALARS()

}  // namespace cageproof::closed_form::published
