// SPDX-License-Identifier: MIT
#include "collocation.h"

namespace cageproof::solved {

std::vector<CollocationPoint> points_on(const RefinedPolygon& polygon, const PiecePoints& of_piece) {
  std::vector<CollocationPoint> points;
  for (int e = 0; e < polygon.edges(); ++e)
    for (int k = 0; k < polygon.pieces_an_edge(); ++k)
      for (const int part : of_piece.taken) points.push_back({e, k, part, of_piece.parts});
  return points;
}

}  // namespace cageproof::solved
