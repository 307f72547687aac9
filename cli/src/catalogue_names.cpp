// SPDX-License-Identifier: MIT
#include "catalogue_names.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"

#include <algorithm>

namespace cageproof::cli {

std::vector<std::string_view> other_checks() {
  std::vector<std::string_view> names = validation::promised_checks();
  std::erase_if(names, [](std::string_view name) { return validation::find_check(name) != nullptr; });
  return names;
}

std::vector<CoordinateBlock> own_blocks(const CoordinateKind& kind) {
  return CageCoordinates(embedded_cage(kind.own_dimension == 2 ? "square" : "cube"), kind, {}).blocks();
}

std::vector<std::string_view> whole_evaluations_of(const CoordinateKind& kind) {
  std::vector<std::string_view> names;
  if (!kind.is_sum()) return names;
  for (const char* cage : {"cube", "square"})
    for (const std::string_view name : whole_evaluation_names(kind, embedded_cage(cage)))
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace cageproof::cli
