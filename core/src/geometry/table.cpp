// SPDX-License-Identifier: MIT
#include "types.h"

#include <algorithm>

namespace cageproof {

const ElementType& type_of(ElementKind kind) {
  // In the order of ElementKind.
  static const std::array<const ElementType*, element_kinds.size()> table{&elements::segment(), &elements::triangle(),
                                                                          &elements::quad()};
  return *table[static_cast<std::size_t>(kind)];
}

ElementKind kind_with_corners(int corners) {
  return *std::ranges::find(element_kinds, corners, [](ElementKind kind) { return type_of(kind).corners; });
}

}  // namespace cageproof
