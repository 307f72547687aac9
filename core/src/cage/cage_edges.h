// SPDX-License-Identifier: MIT
// The edges of a cage's faces: which faces meet along them, and what hangs together by them.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <span>
#include <utility>
#include <vector>

namespace cageproof::cage_checks {

/// A face along an edge.
struct EdgeUse {
  int low, high;  ///< the edge's vertices
  int way;        ///< 1: the face runs towards the higher vertex; -1: towards the lower one
  int face;
  int corner;  ///< of the face, where it sets out
};

/// All edges of all faces. Uses of one edge are consecutive, ordered by face.
std::vector<EdgeUse> edge_uses(const std::vector<Face>& faces);

/// Calls f(uses) for each edge, with the uses of it.
template <class F>
void for_each_edge_of(std::span<const EdgeUse> uses, F&& f) {
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].low == uses[first].low && uses[last].high == uses[first].high) ++last;
    f(uses.subspan(first, last - first));
  }
}

/// Faces run along an edge so many times more towards its higher vertex than towards its lower one; 0 where it is
/// closed.
int balance(std::span<const EdgeUse> uses);

/// The closed surfaces that faces make, by one number per face. Faces hang together by edges that belong to two; where
/// more share an edge, they do in pairs that hold the same wedge between them, exactly decided. \pre all edges are
/// closed
std::vector<int> surfaces_of(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces);

/// Edges of more than two faces, and vertices whose faces form more than one fan, that is, hang together by no edge
/// at it: where parts of a surface meet, or it meets itself.
struct Meetings {
  std::vector<std::pair<int, int>> edges;
  std::vector<int> vertices;  ///< that are on none of these edges
};
Meetings meetings_of(const std::vector<Face>& faces, std::size_t vertex_count);

}  // namespace cageproof::cage_checks
