// SPDX-License-Identifier: MIT
#include "cageproof/core/enclosed.h"

#include <algorithm>
#include <map>

namespace cageproof {

bool is_closed(const Joined& joined) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : joined.faces)
    for (std::size_t k = 0; k < face.size(); ++k) ++edges[{face[k], face[(k + 1) % face.size()]}];
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other == edges.end() || other->second != count) return false;
  }
  if (joined.dimension == 3) return true;
  std::map<int, int> ends;
  for (const auto& [a, b] : joined.segments) {
    ++ends[a];
    --ends[b];
  }
  return std::ranges::all_of(ends, [](const auto& end) { return end.second == 0; });
}

double content_of(const Joined& joined, std::span<const Vec3<double>> vertices, const ContentUnit& unit) {
  double sum = 0;
  const auto from = [&](int v) -> Vec3<double> { return (vertices[v] - vertices.front()) / unit.length; };
  const auto turned = [](const Vec3<double>& u, const Vec3<double>& v) { return u[0] * v[1] - u[1] * v[0]; };
  for (const auto& face : joined.faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vec3<double> a = from(face[0]), b = from(face[k - 1]), c = from(face[k]);
      sum += (joined.dimension == 3 ? a.dot(b.cross(c)) : turned(b - a, c - a)) / unit.simplices;
    }
  if (joined.dimension == 3) return sum;
  for (const auto& [a, b] : joined.segments) sum += turned(from(a), from(b)) / unit.simplices;
  return sum;
}

}  // namespace cageproof
