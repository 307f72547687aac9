// SPDX-License-Identifier: MIT
// Meshes deformed by posed cages: images of points.
#pragma once

#include "coordinate_table.h"

#include "cageproof/deformation/deformer.h"

#include <memory>

namespace cageproof::cli {

/// What becomes of points that have no image: those outside the cage, of coordinates that mean nothing there, and
/// those without coordinates.
enum class OutsidePolicy { Error, Rest, Nan };

/// A mesh under one map.
struct Deformed {
  Mesh mesh;                        ///< as at rest, vertices moved
  CoordinateColumns table;          ///< `x`, `y`, `z`, `x_dx` ..., a row a point
  std::vector<char> without_image;  ///< a point each
};

using Maps = std::vector<const deformation::Posed<double>*>;

/// The mesh under each map. Coordinates are computed once a point, whatever the number of maps.
/// \pre the maps are made from the coordinates, order is none that they have not
/// \throws InputError, by that policy, for points without images, and always for images that are not finite
std::vector<Deformed> deform(const CageCoordinates& coordinates, const Cage& cage, const Mesh& mesh, const Maps& maps,
                             int order, OutsidePolicy outside, int jobs);

}  // namespace cageproof::cli
