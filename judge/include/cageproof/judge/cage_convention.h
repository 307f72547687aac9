// SPDX-License-Identifier: MIT
// How somebody else's coordinates of whole cages mean the same as ours: factors, areas, an order of blocks.
#pragma once

#include "cageproof/judge/cage_request.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::judge {

/// The map from our coordinates of a kind to theirs. It never depends on the cage or the point.
struct CageConvention {
  /// One block of coordinates: of all vertices, or of all faces.
  struct Block {
    std::size_t ours = 0;  ///< its place in the kind's order of blocks
    double factor = 1;     ///< theirs = factor * area^area_power * ours
    int area_power = 0;    ///< -1, 0 or 1 of each face's area, or segment's length; 0 for blocks of vertices
  };
  std::vector<Block> blocks;  ///< in their order
  std::string sentence;       ///< "yours is ours"; "yours is ours with faces' psi times 4 pi"

  /// Whether theirs and ours are the same numbers.
  bool is_ours() const;
  /// \param theirs coordinates of one point of the question's cage
  /// \return ours for theirs; what has another size is returned as it is
  std::vector<double> in_ours(const CageRequest& question, std::string_view kind, std::vector<double> theirs) const;
};

/// Solves for the convention at points inside three cages: all must agree to 1e-9, or, as
/// numbers in float do, to 1e-5.
/// \return nothing where no convention fits them
/// \param kind, dimension as for require_judged_kind
std::optional<CageConvention> find_cage_convention(const WholeCageFunction& theirs, std::string_view kind,
                                                   int dimension = 3);

}  // namespace cageproof::judge
