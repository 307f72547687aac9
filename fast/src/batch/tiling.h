// SPDX-License-Identifier: MIT
// Tiles of a cage's faces, of which kernels take one after the other.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::closed_form::batch {

/// The arrays behind Tiles.
class Tiling {
 public:
  /// \param order in which faces are taken
  Tiling(std::span<const FaceTable<double>> faces, std::span<const EdgeTable<double>> edges,
         std::span<const std::size_t> order);
  Tiling() = default;

  Tiles tables() const;

 private:
  std::vector<int> first_face_, first_vertex_, first_edge_, face_, vertex_;
  std::vector<TileEdge> edge_;
  std::vector<std::array<int, 6>> slot_;
};

}  // namespace cageproof::closed_form::batch
