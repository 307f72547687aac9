// SPDX-License-Identifier: MIT
// Cages, poses and meshes of [T18]'s and [T24]'s figures in space, made in code.
#pragma once

#include "figure_shapes.h"

#include <array>
#include <functional>
#include <string>

namespace cageproof::validation {

/// A bar like bar_cage(), of so many pieces along z: pieces = 1 is a box of six quads.
Cage plain_bar(int pieces);

/// Vertices turned about z by an angle that grows along z, from 0 at z = -1 to so many radians at z = 1.
std::vector<Vec3<double>> twisted_about_z(std::vector<Vec3<double>> vertices, double angle);

/// Planes at these places of each axis, which cut space in cells.
using CellPlanes = std::array<std::vector<double>, 3>;

/// The border of a union of cells, in quads that face outwards. \param holds whether the cell of these numbers, from 0
/// along each axis, belongs to it
Mesh cell_surface(const CellPlanes& planes, const std::function<bool(const std::array<int, 3>&)>& holds);

/// A two-pronged fork of quads, its prongs along z and close to each other: [-1, 1] x [-0.4, 0.4] x [0, 2], without the
/// gap |x| < 0.12 above z = 0.6.
Cage fork_cage();

/// A smooth mesh within the fork. \param step about the edges' length
TonedMesh fork_mesh(double step);

/// A tower of bent quads on a wide base: [-0.4, 0.4]^2 x [0, 0.8], its top turned by 40 degrees, on [-1, 1]^2 x [-1,
/// 0]. Extended diagonals of the tower's quads run through the base.
Cage tower_cage();

/// A flat sheet in the base of the tower, across these diagonals. \param step the edges' length
TonedMesh tower_sheet(double step);

/// A pencil along z, [-1, 1.6]: a tube of six quads a ring, closed below by a fan of triangles and above by a tip of
/// triangles.
Cage pencil_cage();

/// A mesh of revolution within the pencil. \param around faces around it
TonedMesh pencil_mesh(int around);

}  // namespace cageproof::validation
