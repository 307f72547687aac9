// SPDX-License-Identifier: MIT
#include "query_numbers.h"

namespace cageproof::cli {

void require_extent(const QueryText& text, const Formula& formula) {
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(text.corners.size());
  for (const auto& c : text.corners)
    corners.emplace_back(*parse_scalar<Mp200>(c[0]), *parse_scalar<Mp200>(c[1]), *parse_scalar<Mp200>(c[2]));
  const ElementType& type = type_of(formula.element);
  if (type.degenerate(corners)) throw InputError(std::string(type.degenerate_text));
}

}  // namespace cageproof::cli
