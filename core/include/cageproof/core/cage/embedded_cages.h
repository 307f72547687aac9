// SPDX-License-Identifier: MIT
// Cages made in code, so that verification needs no file.
#pragma once

#include "cageproof/core/cage/cage.h"

namespace cageproof {

/// Returns the names of the embedded cages, in report order: cube, icosphere, torus, l-block, twisted-bar, thin-box,
/// spiky-box; in the plane square, l-shape, star, comb, thin-bar, frame (a square with a hole), figure (100 edges).
std::vector<std::string_view> embedded_cage_names();

/// Returns the names of the extreme cages, in report order. A number in a name is a length that a family is swept over:
/// thin-wall-1e-1 ... (a box open at the top), wedge-1e-2 ..., crack-1e-2 ..., hollow-1e-3 ... (a cube around a
/// cavity), gap-1e-3 ... (two cubes), nested (shells and cavities in turn), fan (64 triangles at a vertex), bevel-1e-2
/// ... (a tetrahedron with a corner cut off), bump-1e-2 ... (a small pyramid on a cube), pinch-1e-2 ... (an hourglass),
/// needles-1e-2 ... (a rounded corner, joined to far vertices), graded (rings of faces from 1 to 1e-8).
std::vector<std::string_view> extreme_cage_names();

/// Whether embedded_cage knows the name.
bool is_embedded_cage(std::string_view name);

/// The embedded cage of that name, ordinary or extreme.
/// \throws InputError listing the names there are
Cage embedded_cage(std::string_view name);

}  // namespace cageproof
