// SPDX-License-Identifier: MIT
// The connected parts of a cage, and how they lie in each other.
#pragma once

#include "cage_checks.h"

namespace cageproof::cage_checks {

/// A closed surface (cage_edges.h), or in the plane a loop.
struct Part {
  std::vector<int> faces;   ///< in rising order; the first one names the part
  int orientation;          ///< +1: its normals point away from the inside; -1: into it
  std::vector<int> around;  ///< the parts that it lies within

  /// Parts that lie within an even number of others are shells, with normals outward; the others bound cavities.
  int expected() const { return around.size() % 2 == 0 ? 1 : -1; }
};

/// The parts, in the order of their first faces. One lies within another when that winds around those of its vertices
/// that do not lie on it; so parts that cross each other lie beside each other. Quads are cut by the diagonal at their
/// first corner, or by the other one where that folds them. Exact.
/// \pre check_edges passed, in the plane all of polygon_checks.h \throws InputError for a part without
/// volume
std::vector<Part> parts_of(const Candidate& cage);

/// Why the part should be turned, for a message.
std::string wrong_way(const Candidate& cage, const std::vector<Part>& parts, const Part& part);

}  // namespace cageproof::cage_checks
