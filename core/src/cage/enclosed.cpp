// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/enclosed.h"

#include <algorithm>
#include <limits>
#include <map>

namespace cageproof {

bool is_closed(const Connectivity& connectivity) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : connectivity.faces)
    for (std::size_t k = 0; k < face.size(); ++k) ++edges[{face[k], face[(k + 1) % face.size()]}];
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other == edges.end() || other->second != count) return false;
  }
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
