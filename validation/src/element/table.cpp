// SPDX-License-Identifier: MIT
#include "element_sampling.h"

namespace cageproof::validation {

const ElementSampling& sampling_of(ElementKind kind) {
  // In the order of ElementKind.
  static const std::array<const ElementSampling*, element_kinds.size()> table{&segment_sampling(), &triangle_sampling(),
                                                                              &quad_sampling()};
  return *table[static_cast<std::size_t>(kind)];
}

}  // namespace cageproof::validation
