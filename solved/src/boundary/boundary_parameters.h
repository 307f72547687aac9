// SPDX-License-Identifier: MIT
// The parameters of kinds that are solved by boundary elements.
#pragma once

#include "refined_polygon.h"

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::solved {

/// `pieces` and `collocation`, the names of what `where` lists, the second of which is the default. \param meaning of
/// collocation
template <class Collocations>
std::vector<KindParameter> boundary_parameters(const Collocations& where, std::string_view meaning) {
  std::vector<std::string_view> names;
  names.reserve(where.size());
  for (const auto& collocation : where) names.push_back(collocation.name);
  return {
      {{.name = "pieces",
        .preset = default_pieces,
        .lowest = 0,
        .highest = 64,
        .includes_highest = true,
        .whole = true},
       "that each edge is cut into"},
      {{.name = "collocation", .preset = 1, .lowest = -1, .highest = static_cast<double>(where.size()), .whole = true},
       meaning,
       names}};
}

/// `unit`, that systems are solved in, after `pieces` and `collocation`: the names stand for RefinedPolygon::Unit.
inline KindParameter unit_parameter() {
  return {{.name = "unit", .preset = 0, .lowest = -1, .highest = 2, .whole = true},
          "of length that systems are solved in: the cage's diameter, or its own as the paper's",
          {"diameter", "own"}};
}

/// The parameter `unit`; the diameter for kinds without it.
inline RefinedPolygon::Unit unit_of(const std::vector<double>& parameters) {
  return parameters.size() > 2 && parameters[2] == 1 ? RefinedPolygon::Unit::Own : RefinedPolygon::Unit::Diameter;
}

}  // namespace cageproof::solved
