// SPDX-License-Identifier: MIT
// The rows of the table of element types, one folder each.
#pragma once

#include "cageproof/core/geometry/element.h"

namespace cageproof::elements {

const ElementType& segment();
const ElementType& triangle();
const ElementType& quad();

}  // namespace cageproof::elements
