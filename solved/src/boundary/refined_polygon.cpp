// SPDX-License-Identifier: MIT
#include "refined_polygon.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::solved {

RefinedPolygon::RefinedPolygon(const Cage& cage, int pieces, Unit unit) : pieces_(pieces), vertices_(cage.vertices()) {
  std::vector<int> ending_at(vertices_.size());
  for (const Face& face : cage.faces()) {
    ending_at[face.vertices[1]] = edges();
    edges_.push_back({face.vertices[0], face.vertices[1]});
  }
  after_.resize(edges_.size());
  for (const auto& edge : edges_) {
    before_.push_back(ending_at[edge[0]]);
    after_[before_.back()] = static_cast<int>(before_.size()) - 1;
  }
  if (nodes() > most_nodes)
    throw InputError(fmt::format("{}: {} edges in {} pieces each have {} nodes, more than {}", cage.name(), edges(),
                                 pieces, nodes(), most_nodes));
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) diameter_ = std::max(diameter_, (vertices_[i] - vertices_[j]).stableNorm());
  if (unit == Unit::Diameter) unit_ = diameter_;
  // Two digits of an edge's length are no matter.
  constexpr double least = 1. / 128;
  for (const auto& [from, to] : edges_)
    if ((vertices_[to] - vertices_[from]).stableNorm() < least * diameter_) sees_from_ends_ = true;
}

std::string why_not_refined(const Cage& cage) {
  const int nodes = default_pieces * static_cast<int>(cage.faces().size());
  if (nodes <= RefinedPolygon::most_nodes) return "";
  return fmt::format("{} edges in {} pieces each have {} nodes, more than {}", cage.faces().size(), default_pieces,
                     nodes, RefinedPolygon::most_nodes);
}

}  // namespace cageproof::solved
