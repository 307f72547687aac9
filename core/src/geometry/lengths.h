// SPDX-License-Identifier: MIT
// Tells which of two segments of space is longer, exactly, for any finite doubles.
#pragma once

#include "cageproof/core/geometry/element.h"

namespace cageproof {

/// -1 where `a` is shorter than `b`, 0 where they are equally long, +1 where it is longer.
int compare_lengths(const Segment<double>& a, const Segment<double>& b);

}  // namespace cageproof
