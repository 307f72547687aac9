// SPDX-License-Identifier: MIT
#include "missed_vertices.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::solved {

void require_vertices_met(const HasLimits& coordinates, const CoordinateBlock& block, const RefinedSurface& surface,
                          std::string_view cage, std::string_view kind, std::string_view data, double most) {
  constexpr double at_corner = 0.984375, beside = 0.0078125;
  std::vector<Touching> places;
  for (int t = 0; t < surface.triangles(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      Touching place{t, {beside, beside, beside, 0}};
      place.basis[k] = at_corner;
      places.push_back(place);
    }
  // Coordinates are numbers, or square matrices whose diagonals are the hat functions.
  const auto rows = static_cast<std::size_t>(block.shape.rows), entries = rows * rows;
  std::vector<CoordinateTable<double>> found(1);
  const std::size_t stride = entries * static_cast<std::size_t>(block.size);
  found[0].stride[0] = stride;
  found[0].tensors[0].assign(places.size() * stride, 0);
  coordinates.fill_limits(places, 0, found);
  for (std::size_t p = 0; p < places.size(); ++p) {
    double* const values = &found[0].tensors[0][p * stride];
    const auto corners = surface.vertices_of(places[p].element);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < rows; ++i)
        values[entries * static_cast<std::size_t>(corners[k]) + (rows + 1) * i] -= places[p].basis[k];
    double off = 0;
    for (std::size_t v = 0; v < stride; ++v) off = std::max(off, std::abs(values[v]));
    if (off > most)
      throw InputError(fmt::format(
          "{}: no {} coordinates at this level: on triangle {} (counted from 0, quads split) they miss the {} that "
          "they "
          "interpolate by {:.2g}: a wall is too thin for the pieces of its faces, or parts overlap; take a higher "
          "level, divide the faces of thin walls, or take mean_value",
          cage, kind, places[p].element, data, off));
  }
}

std::string why_too_many_unknowns(const Cage& cage, int densities, int level) {
  const std::size_t unknowns =
      cage.parts(false, Triangulation::Shortest).elements.size() * densities * (1 << (2 * level));
  if (unknowns <= RefinedSurface::most_unknowns) return "";
  return fmt::format("its triangles have {} unknowns at level {}, more than {}; take a lower level", unknowns, level,
                     RefinedSurface::most_unknowns);
}

}  // namespace cageproof::solved
