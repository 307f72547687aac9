// SPDX-License-Identifier: MIT
// Harmonic coordinates of triangulated cages (Joshi et al. 2007), from Green's identity with layers a hair inside of
// the cage in place of limits, by elimination in 200 digits.
#pragma once

#include "elimination.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <vector>

namespace cageproof::second_routes {

/// With triangles split in four once, by their edges' midpoints, and normal derivatives that are affine on each
/// quarter. The identity is asked to hold where the basis functions of a quarter are 5/8, 3/16 and 3/16.
class SurfaceRoute {
 public:
  explicit SurfaceRoute(const Cage& cage);
  /// Coordinates of values at vertices.
  std::vector<Mp200> at(const Vec3<double>& point) const;

 private:
  using Corners = std::array<Vec3<Mp50>, 3>;
  /// Layers at one point: phi, one number per vertex, and psi, one per corner of a quarter.
  struct Layers {
    std::vector<Mp200> phi, psi;
  };
  Layers layers_at(const Vec3<Mp50>& point) const;

  std::size_t vertices_;
  Evaluation double_layer_, single_layer_;
  std::vector<std::array<int, 3>> numbers_;  ///< of each triangle's vertices
  std::vector<Corners> triangles_, quarters_;
  Table<Mp200> slopes_;  ///< normal derivatives at corners of quarters, one column per vertex
};

}  // namespace cageproof::second_routes
