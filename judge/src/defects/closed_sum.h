// SPDX-License-Identifier: MIT
// A formula's sum over the elements of a small closed cage.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::judge {

/// Whether derivatives of that order, summed over the triangles of a tetrahedron or the segments of a triangle and at
/// each of its vertices, are right to a thousandth of a single error. False for quads, which no cage of so few has.
bool closed_sum_is_right(const Evaluation& ours, int order);

}  // namespace cageproof::judge
