// SPDX-License-Identifier: MIT
// Polygons of the plane and meshes that fill them.
#pragma once

#include "figure_shapes.h"

#include <array>
#include <string>
#include <vector>

namespace cageproof::validation {

/// A quad of a polygon, counter-clockwise, cut into `across` by `up` cells: `across` along its first edge. Corners
/// count the polygon's vertices, then points inside it.
struct Patch {
  std::array<int, 4> corners;
  int across, up;
};

/// A polygon of the plane from its vertices, counter-clockwise.
Cage polygon_of(std::string name, std::vector<Vec3<double>> vertices);

/// The mesh of patches that fill a polygon. Its border lies a millionth of the polygon's size inside, so that no vertex
/// of a slanted edge is outside by rounding. \pre patches that share an edge cut it into as many cells
/// \param inner points inside that patches have for corners
TonedMesh patched(const Cage& cage, const std::vector<Vec3<double>>& inner, const std::vector<Patch>& patches);

/// Points next to each edge, at a distance of so many sizes of the cage, evenly along it and not at its ends.
std::vector<Vec3<double>> beside_edges(const Cage& cage, double depth, int per_edge);

/// The square [0, 1] x [0, 1].
Cage plane_square();
TonedMesh square_mesh(const Cage& square, int cells);

/// A star of five tips around the origin, 2 and 1 from it.
Cage plane_star();
TonedMesh star_mesh(const Cage& star);
/// The star with its tips turned about the origin, and the upper one drawn out.
std::vector<Vec3<double>> swirled_star(const Cage& star);
/// The star with its arms lifted, and the upper tip drawn out.
std::vector<Vec3<double>> lifted_star(const Cage& star);

/// Trousers: two legs beside a narrow gap. The first leg has vertices 0, 1, 2 and 9.
Cage plane_trousers();
TonedMesh trousers_mesh(const Cage& trousers);
/// The second leg lifted outwards.
std::vector<Vec3<double>> lifted_leg(const Cage& trousers);

/// An animal with a long neck.
Cage plane_animal();
TonedMesh animal_mesh(const Cage& animal);

}  // namespace cageproof::validation
