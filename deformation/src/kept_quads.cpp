// SPDX-License-Identifier: MIT
#include "kept_quads.h"

#include <fmt/format.h>

namespace cageproof::deformation {

std::string why_quads_are_refused(const Cage& cage) {
  if (cage.dimension() == 2) return "polygons have no quads that could be kept";
  const CageElements elements(cage, true, Triangulation::Shortest);
  for (std::size_t i = 0; i < elements.count(Owner::Normal); ++i)
    if (!(elements.area_element_of(i, Owner::Normal) > 0))
      return fmt::format("a corner of face {} has no area, and so no normal", elements.element_of(i, Owner::Normal));
  return {};
}

KindParameter stretch_parameter(std::string_view name, std::string_view description, Stretch preset, bool keeps_quads) {
  const auto& names = keeps_quads ? quad_stretch_names() : stretch_names();
  return {{.name = name,
           .preset = static_cast<double>(preset),
           .lowest = -1,
           .highest = static_cast<double>(names.size()),
           .whole = true},
          description,
          names};
}

}  // namespace cageproof::deformation
