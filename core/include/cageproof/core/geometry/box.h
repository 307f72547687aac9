// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/numbers/vector.h"

namespace cageproof {

/// The corners of an axis-parallel box.
struct Box {
  Vec3<double> low, high;
};

/// The least box around points. \pre there is a point
template <class Points>
Box box_of(const Points& points) {
  Box box{*points.begin(), *points.begin()};
  for (const Vec3<double>& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

}  // namespace cageproof
