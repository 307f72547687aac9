// SPDX-License-Identifier: MIT
// A vertex seen from a vector of points.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "cageproof/closed_form/batch/tables.h"
#include "vectors.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

struct SeenVertex {
  Three<Lanes> x;  ///< from the point to it
  Lanes r;         ///< its distance
  Mask near;       ///< whether its faces need more digits
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
