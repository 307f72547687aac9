// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/judge/cage_vectors.h"

namespace cageproof::judge {

/// Adds the names of the defects that fail at a vector. \param is_on whether its point is on the cage
void add_defects(CageVector& vector, const CageVectorSet& set, bool is_on);

}  // namespace cageproof::judge
