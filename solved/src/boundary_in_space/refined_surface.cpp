// SPDX-License-Identifier: MIT
#include "refined_surface.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::solved {

RefinedSurface::RefinedSurface(const Cage& cage, const CageElements& elements, int level, int densities)
    : vertices_(elements.vertices()) {
  const double unknowns = static_cast<double>(elements.count()) * densities * (1 << (2 * level));
  if (unknowns > most_unknowns)
    throw InputError(fmt::format(
        "{}: {} triangles at level {} have {:.0f} unknowns, more than {}, whose matrix takes half a gigabyte; "
        "take a lower level or a cage of fewer faces",
        cage.name(), elements.count(), level, unknowns, most_unknowns));
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto v = elements.vertices_of(e);
    triangles_.push_back({v[0], v[1], v[2]});
  }
  unit_ = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) unit_ = std::max(unit_, (vertices_[i] - vertices_[j]).stableNorm());
  const int n = 1 << level;
  const auto node = [n](int i, int j) { return std::array<double, 2>{1. * i / n, 1. * j / n}; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + j < n; ++i) {
      pieces_.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
      if (i + j + 1 < n) pieces_.push_back({node(i + 1, j + 1), node(i, j + 1), node(i + 1, j)});
    }
}

PlaceOnTriangle RefinedSurface::place(int triangle, int k, double second, double third) const {
  const auto& [a, b, c] = pieces_[k];
  const auto along = [&](int i) { return a[i] + second * (b[i] - a[i]) + third * (c[i] - a[i]); };
  return {triangle, along(0), along(1)};
}

std::vector<PlaceOnTriangle> collocation_places(const RefinedSurface& surface) {
  // Next to the points of the rule that integrates quadratic functions, 1/6 and 2/3, and dyadic.
  constexpr double near = 0.1875, far = 0.625;
  std::vector<PlaceOnTriangle> places;
  for (int t = 0; t < surface.triangles(); ++t)
    for (int k = 0; k < surface.pieces_a_triangle(); ++k)
      for (const auto& [second, third] : {std::array{near, near}, std::array{far, near}, std::array{near, far}})
        places.push_back(surface.place(t, k, second, third));
  return places;
}

}  // namespace cageproof::solved
