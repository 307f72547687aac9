// SPDX-License-Identifier: MIT
// Makes an input that shows a defect as plain as it can be.
#pragma once

#include "cageproof/validation/sample.h"

#include <functional>

namespace cageproof::judge {

/// Characters that an input's coordinates take in decimals: what is plain is short.
std::size_t length_of(const validation::Sample& sample, int dim);

/// Takes simpler inputs, of elements that are not degenerate, as long as the defect shows: the unit triangle or
/// segment, a corner at the origin, coordinates of fewer digits, zeros and ones. \param shows whether an input still
/// has the defect; asked a hundred times at most
validation::Sample shrunk(validation::Sample sample, ElementKind element,
                          const std::function<bool(const validation::Sample&)>& shows);

}  // namespace cageproof::judge
