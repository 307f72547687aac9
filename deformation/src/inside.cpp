// SPDX-License-Identifier: MIT
#include "cageproof/deformation/inside.h"

namespace cageproof::deformation {

bool Inside::holds(const Vec3<double>& point) const { return windings_.around(point).value_or(1) != 0; }

}  // namespace cageproof::deformation
