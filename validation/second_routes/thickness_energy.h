// SPDX-License-Identifier: MIT
// The energy of [W12] Eq 22 as a sum, and its constraints, as functions of the posed vertices.
#pragma once

#include "elimination.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <vector>

namespace cageproof::second_routes {

/// f = alpha F + beta n'(F), n' the unit normals of the posed edges, outward: to the right of them.
class ThicknessEnergy {
 public:
  /// \param coordinates alpha and beta, taken as given in double: one coordinate per vertex, then one per edge
  /// \param samples of each edge, at fractions (q + 1/2)/samples \param at where positions are prescribed
  ThicknessEnergy(const CageCoordinates& coordinates, int samples, const std::vector<Vec3<double>>& at);

  /// Coordinates of the vertices, x and y in turn.
  using Unknowns = std::vector<Mp50>;

  /// sum over samples of |d^2 f / dn^2|^2, n the rest normal.
  Mp50 of(const Unknowns& vertices) const;
  /// Images of the prescribed positions, x and y in turn.
  std::vector<Mp50> images(const Unknowns& vertices) const;
  /// Share of the energy's gradient that remains along the images' kernel, by central differences, whose step leaves 20
  /// digits. Zero where the energy is stationary among poses with these images.
  double slope_along_constraints(const Unknowns& vertices) const;

 private:
  struct Row {
    std::vector<Mp50> of_vertices, of_normals;
  };
  std::array<Mp50, 2> at_row(const Row& row, const Unknowns& vertices) const;

  const CageElements& elements_;
  std::vector<Row> bending_, positions_;
};

}  // namespace cageproof::second_routes
