// SPDX-License-Identifier: MIT
#include "tiling.h"

#include <algorithm>

namespace cageproof::closed_form::batch {
namespace {

// The number of faces in a tile, so that the results of its some 200 edges fit into the second cache.
constexpr std::size_t kTile = 128;

// Numbers things of a tile as they are met.
class Slots {
 public:
  explicit Slots(std::size_t count) : slot_(count, -1) {}
  // \return where the thing is among the tile's; calls added(thing) for a new one
  template <class Added>
  int of(int thing, Added added) {
    if (slot_[thing] < 0) {
      slot_[thing] = static_cast<int>(met_.size());
      met_.push_back(thing);
      added(thing);
    }
    return slot_[thing];
  }
  void clear() {
    for (const int thing : met_) slot_[thing] = -1;
    met_.clear();
  }

 private:
  std::vector<int> slot_, met_;
};

}  // namespace

Tiling::Tiling(std::span<const FaceTable<double>> faces, std::span<const EdgeTable<double>> edges,
               std::span<const std::size_t> order)
    : slot_(faces.size()) {
  int vertices = 0;
  for (const EdgeTable<double>& e : edges) vertices = std::max({vertices, e.from + 1, e.to + 1});
  Slots vertex(vertices), edge(edges.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % kTile == 0) {
      first_face_.push_back(static_cast<int>(i));
      first_vertex_.push_back(static_cast<int>(vertex_.size()));
      first_edge_.push_back(static_cast<int>(edge_.size()));
      vertex.clear();
      edge.clear();
    }
    const auto slot_of = [&](int v) { return vertex.of(v, [&](int added) { vertex_.push_back(added); }); };
    const int f = static_cast<int>(order[i]);
    face_.push_back(f);
    for (int k = 0; k < 3; ++k) slot_[f][k] = slot_of(faces[f].vertex[k]);
    for (int e = 0; e < 3; ++e)
      slot_[f][3 + e] = edge.of(faces[f].edge[e], [&](int added) {
        edge_.push_back({added, slot_of(edges[added].from), slot_of(edges[added].to)});
      });
  }
  first_face_.push_back(static_cast<int>(face_.size()));
  first_vertex_.push_back(static_cast<int>(vertex_.size()));
  first_edge_.push_back(static_cast<int>(edge_.size()));
}

Tiles Tiling::tables() const {
  // An array of arrays is laid out as one.
  return {static_cast<int>(first_face_.size()) - 1,
          first_face_.data(),
          first_vertex_.data(),
          first_edge_.data(),
          face_.data(),
          vertex_.data(),
          edge_.data(),
          reinterpret_cast<const int(*)[6]>(slot_.data())};
}

}  // namespace cageproof::closed_form::batch
