// SPDX-License-Identifier: MIT
#include "collocation.h"

namespace cageproof::solved {

const std::vector<Collocation>& collocations() {
  const PiecePoints nodes{1, {0}}, midpoints{2, {1}}, both{2, {0, 1}}, quarters{4, {0, 1, 2, 3}};
  static const std::vector<Collocation> all{{"vertices", nodes, nodes},
                                            {"vertices-and-midpoints", both, both},
                                            {"quarter-points", quarters, quarters},
                                            {"mixed", midpoints, nodes},
                                            {"mixed-and-midpoints", midpoints, both}};
  return all;
}

std::vector<CollocationPoint> points_on(const RefinedPolygon& polygon, const PiecePoints& of_piece) {
  std::vector<CollocationPoint> points;
  for (int e = 0; e < polygon.edges(); ++e)
    for (int k = 0; k < polygon.pieces_an_edge(); ++k)
      for (const int part : of_piece.taken) points.push_back({e, k, part, of_piece.parts});
  return points;
}

}  // namespace cageproof::solved
