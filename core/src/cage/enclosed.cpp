// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/enclosed.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace cageproof {

namespace {

// Whether each edge of a face is that of another the other way round. Edges are sorted by their lesser vertex with as
// many steps as there are edges, then by the other within these few.
bool edges_cancel(const std::vector<std::vector<int>>& faces) {
  const auto for_each_edge = [&](auto with) {
    for (const auto& face : faces)
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int from = face[k], to = face[k + 1 < face.size() ? k + 1 : 0];
        // An edge from a vertex to itself is the same both ways.
        if (from != to) with(std::min(from, to), std::max(from, to), from < to ? 1 : -1);
      }
  };
  int vertices = 0;
  for_each_edge([&](int, int high, int) { vertices = std::max(vertices, high + 1); });
  std::vector<std::size_t> end(vertices + 1, 0);
  for_each_edge([&](int low, int, int) { ++end[low + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  struct Way {
    int to, sign;
  };
  std::vector<Way> ways(end.back());
  std::vector<std::size_t> next(end.begin(), end.end() - 1);
  for_each_edge([&](int low, int high, int sign) { ways[next[low]++] = {high, sign}; });
  for (int low = 0; low < vertices; ++low) {
    const std::span mine = std::span(ways).subspan(end[low], end[low + 1] - end[low]);
    std::ranges::sort(mine, {}, &Way::to);
    for (std::size_t i = 0; i < mine.size();) {
      const int to = mine[i].to;
      std::ptrdiff_t sum = 0;
      for (; i < mine.size() && mine[i].to == to; ++i) sum += mine[i].sign;
      if (sum != 0) return false;
    }
  }
  return true;
}

}  // namespace

bool is_closed(const Connectivity& connectivity) {
  if (!edges_cancel(connectivity.faces)) return false;
  if (connectivity.dimension == 3) return true;
  std::map<int, int> ends;
  for (const auto& [a, b] : connectivity.segments) {
    ++ends[a];
    --ends[b];
  }
  return std::ranges::all_of(ends, [](const auto& end) { return end.second == 0; });
}

Content content_of(const Connectivity& connectivity, std::span<const Vec3<double>> vertices, const ContentUnit& unit) {
  double sum = 0, sizes = 0;
  std::size_t terms = 0;
  const auto add = [&](double part) {
    sum += part;
    sizes += std::abs(part);
    ++terms;
  };
  const auto from = [&](int v) -> Vec3<double> { return (vertices[v] - vertices.front()) / unit.length; };
  const auto turned = [](const Vec3<double>& u, const Vec3<double>& v) { return u[0] * v[1] - u[1] * v[0]; };
  for (const auto& face : connectivity.faces) {
    const std::size_t corners = face.size(), fans = corners == 4 ? 2 : 1;
    for (std::size_t first = 0; first < fans; ++first)
      for (std::size_t k = 2; k < corners; ++k) {
        const Vec3<double> a = from(face[first]), b = from(face[(first + k - 1) % corners]),
                           c = from(face[(first + k) % corners]);
        const double part = connectivity.dimension == 3 ? a.dot(b.cross(c)) : turned(b - a, c - a);
        add(part / static_cast<double>(fans) / unit.simplices);
      }
  }
  if (connectivity.dimension == 2)
    for (const auto& [a, b] : connectivity.segments) add(turned(from(a), from(b)) / unit.simplices);
  return {sum, static_cast<double>(terms) * std::numeric_limits<double>::epsilon() * sizes};
}

}  // namespace cageproof
