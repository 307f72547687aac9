// SPDX-License-Identifier: MIT
// A few numbers of a mesh and its image under a map.
#pragma once

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/deformation/point_images.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace cageproof::deformation {

/// Figures of the Jacobians of points that have an image.
struct JacobianMeasures {
  double least_singular_value, largest_singular_value;  ///< infinite where there are no Jacobians
  std::size_t turned = 0;                               ///< points turned inside out, not those pressed flat
  std::size_t without = 0;                              ///< points, on the cage, whose Jacobian is not finite
};

struct MeshMeasures {
  std::size_t missing = 0;      ///< points without image; others count below
  double largest_displacement;  ///< in the mesh's unit of length, as the mean
  double mean_displacement;     ///< NaN, as the largest, where no point has an image
  double cage_ratio;            ///< content of the posed cage over that at rest; NaN without posed cage
  double
      mesh_ratio;  ///< the same of the mesh; NaN where it is open, or holds nothing at rest, as faces in the plane do
  std::optional<JacobianMeasures> jacobians;  ///< where they were asked for
};

/// \param posed the cage's vertices; empty where a map has no posed cage \param size of the cage, the unit that
/// contents are summed in \param images of the mesh's vertices, and `map` that one of the maps, counted from 0; \param
/// order highest derivative that these have
MeshMeasures measures_of(const CageElements& cage, double size, const std::vector<Vec3<double>>& posed,
                         const Mesh& rest, const PointImages& images, std::size_t map, int order);

}  // namespace cageproof::deformation
