// SPDX-License-Identifier: MIT
// Implementations that only give coordinates of whole cages, judged.
#pragma once

#include "cageproof/judge/verdict.h"

#include <array>
#include <functional>

namespace cageproof::judge {

/// A cage of triangles and points in space, as a caller has them.
struct CageQuestion {
  std::vector<Vec3<double>> vertices;
  std::vector<std::array<int, 3>> faces;  ///< counter-clockwise seen from outside
  std::vector<Vec3<double>> points;
};

/// Values of coordinates, [point][coordinate]: first those of all vertices, then those of all faces, for kinds that
/// have them.
using WholeCageFunction = std::function<std::vector<double>(const CageQuestion&)>;

/// One defect of whole cages, with a question that shows it.
struct CageFinding {
  const Defect* defect = nullptr;
  CageQuestion question;             ///< one point
  std::vector<double> ours, theirs;  ///< coordinates of that point
  std::size_t cases = 0;
  std::string evidence;
};

struct CageVerdict {
  std::vector<CageFinding> findings;  ///< none: clean
  std::size_t points = 0;             ///< that were compared with the truth
};

/// Asks on tetrahedra, a cube and an octahedron, at points inside and, of `mean_value`, on them, in three units of
/// length.
/// \param kind "mean_value", "green" or another sum over triangles with numbers for coordinates
/// \throws InputError for a kind that is unknown or has matrices
CageVerdict judge_whole_cage(const WholeCageFunction& theirs, std::string_view kind);

}  // namespace cageproof::judge
