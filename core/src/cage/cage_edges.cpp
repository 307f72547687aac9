// SPDX-License-Identifier: MIT
#include "cage_edges.h"

#include "cageproof/core/geometry/orientation.h"
#include "connected.h"

#include <algorithm>
#include <tuple>

namespace cageproof::cage_checks {

std::vector<EdgeUse> edge_uses(const std::vector<Face>& faces) {
  std::vector<EdgeUse> uses;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < faces[f].size(); ++k) {
      const int from = faces[f].vertices[k], to = faces[f].vertices[(k + 1) % faces[f].size()];
      uses.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1, static_cast<int>(f), k});
    }
  std::ranges::sort(uses, {}, [](const EdgeUse& u) { return std::tuple(u.low, u.high, u.face, u.corner); });
  return uses;
}

int balance(std::span<const EdgeUse> uses) {
  int sum = 0;
  for (const EdgeUse& use : uses) sum += use.way;
  return sum;
}

namespace {

// A face as it stands about an edge, which points at the viewer.
struct Leaf {
  int face;
  int way;           // 1: the surface's inside is on the clockwise side; -1: on the other
  Vec3<double> tip;  // of the half plane
  int sector = 0;    // 0: where the first one is; 1: less than half a turn on; 2: opposite to it; 3: more than half
};

// The faces around an edge, counter-clockwise. In one half plane, faces with their inside on the clockwise side come
// first.
std::vector<Leaf> turned_around(std::span<const EdgeUse> edge, const std::vector<Vec3<double>>& vertices,
                                const std::vector<Face>& faces) {
  const Vec3<double>&low = vertices[edge[0].low], &high = vertices[edge[0].high];
  std::vector<Leaf> leaves;
  for (const EdgeUse& use : edge) {
    const Face& face = faces[use.face];
    const auto corner = [&](int step) { return vertices[face.vertices[(use.corner + step) % face.size()]]; };
    // A quad may have three corners on a line: then the fourth.
    const bool line = face.size() == 4 && on_a_line({low, high, corner(2)});
    leaves.push_back({use.face, use.way, corner(line ? 3 : 2)});
  }
  const Triangle<double> first{low, high, leaves[0].tip};
  for (Leaf& leaf : leaves) {
    const int side = side_of_plane(first, leaf.tip);
    leaf.sector = side > 0 ? 1 : side < 0 ? 3 : side_of_edge(first, 0, leaf.tip) < 0 ? 2 : 0;
  }
  std::ranges::sort(leaves, [&](const Leaf& a, const Leaf& b) {
    if (a.sector != b.sector) return a.sector < b.sector;
    const int side = a.sector % 2 == 0 ? 0 : side_of_plane({low, high, a.tip}, b.tip);
    return side != 0 ? side > 0 : a.way > b.way;
  });
  return leaves;
}

// Joins the faces around an edge in pairs, each about a wedge that both hold, as parentheses are paired.
void join_around(std::span<const EdgeUse> edge, const std::vector<Vec3<double>>& vertices,
                 const std::vector<Face>& faces, Connected& connected) {
  std::vector<Leaf> leaves = turned_around(edge, vertices, faces);
  // Sets out where as few as ever are open.
  int open = 0, fewest = 0;
  std::ptrdiff_t start = 0;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    open -= leaves[k].way;
    if (open >= fewest) continue;
    fewest = open;
    start = static_cast<std::ptrdiff_t>(k) + 1;
  }
  std::ranges::rotate(leaves, leaves.begin() + start);
  std::vector<int> waiting;
  for (const Leaf& leaf : leaves) {
    if (leaf.way < 0) {
      waiting.push_back(leaf.face);
    } else {
      connected.join(waiting.back(), leaf.face);
      waiting.pop_back();
    }
  }
}

}  // namespace

std::vector<int> surfaces_of(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces) {
  const std::vector<EdgeUse> uses = edge_uses(faces);
  Connected connected(faces.size());
  for_each_edge_of(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) connected.join(edge[0].face, edge[1].face);
    else join_around(edge, vertices, faces, connected);
  });
  std::vector<int> found(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) found[f] = connected.root(static_cast<int>(f));
  return found;
}

Meetings meetings_of(const std::vector<Face>& faces, std::size_t vertex_count) {
  Meetings found;
  std::vector<char> on_edge(vertex_count, 0);
  // Corners, numbered four a face, that hang together at their vertex.
  Connected fans(4 * faces.size());
  const auto corner_at = [&](int face, int vertex) {
    const auto& vertices = faces[face].vertices;
    return 4 * face + static_cast<int>(std::ranges::find(vertices, vertex) - vertices.begin());
  };
  const std::vector<EdgeUse> uses = edge_uses(faces);
  for_each_edge_of(uses, [&](std::span<const EdgeUse> edge) {
    for (const int v : {edge[0].low, edge[0].high})
      for (const EdgeUse& use : edge) fans.join(corner_at(edge[0].face, v), corner_at(use.face, v));
    if (edge.size() <= 2) return;
    found.edges.emplace_back(edge[0].low, edge[0].high);
    on_edge[edge[0].low] = on_edge[edge[0].high] = 1;
  });
  std::vector<int> fan_of(vertex_count, -1);
  std::vector<char> several(vertex_count, 0);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < faces[f].size(); ++k) {
      const int v = faces[f].vertices[k], fan = fans.root(4 * static_cast<int>(f) + k);
      if (fan_of[v] < 0) fan_of[v] = fan;
      else if (fan_of[v] != fan) several[v] = 1;
    }
  for (std::size_t v = 0; v < vertex_count; ++v)
    if (several[v] && !on_edge[v]) found.vertices.push_back(static_cast<int>(v));
  return found;
}

}  // namespace cageproof::cage_checks
