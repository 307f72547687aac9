// SPDX-License-Identifier: MIT
// The normal derivatives N' that make an energy of second derivatives on the cage least ([T24] Eq 31-36), from the
// printed normal equations.
#pragma once

#include "densities_route.h"

namespace cageproof::second_routes {

/// The energy's sum of squares: of Laplacians (AHAP), all second derivatives (AAAP), those along the rest normal (TP).
enum class Squares { Laplacians, Hessians, AlongNormal };
/// How normal derivatives go with the posed unit normals: along them (Eq 33), softly (Eq 34), or not at all; or along
/// them and not against.
enum class Along { Hard, Soft, Free, NonNegative };

struct AlignmentMethod {
  Squares squares;
  int level;  ///< of the energy's samples
  Along along;
  Wide gamma_a;  ///< of Soft
};

/// N', one row per element and one column per coordinate. \param densities densities_by_data() \param units the posed
/// unit normals, laid out likewise
Table<Wide> aligned_normals(const CageCoordinates& layers, const Table<Wide>& densities, const AlignmentMethod& method,
                            const Table<Wide>& vertices, const Table<Wide>& units);

/// The s >= 0 of least s.Gs/2 - g.s for a positive definite G: of all sets of unknowns the one whose solution, with the
/// others zero, satisfies the conditions of Karush, Kuhn and Tucker. \pre at most 12 unknowns
Table<Wide> least_not_negative(const Table<Wide>& gram, const Table<Wide>& pull);

}  // namespace cageproof::second_routes
