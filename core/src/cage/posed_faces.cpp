// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/posed_faces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace cageproof {
namespace {

// The corners that follow each other, from the least one in the direction of the lesser neighbour.
std::vector<int> standing(std::vector<int> corners) {
  std::ranges::rotate(corners, std::ranges::min_element(corners));
  if (corners.size() > 2 && corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

std::vector<std::vector<int>> faces_of(const Cage& cage) {
  std::vector<std::vector<int>> faces;
  for (const Face& face : cage.faces()) faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  return faces;
}

// The faces, and each triangle that three corners of a quad make.
std::set<std::vector<int>> with_triangles(const std::vector<std::vector<int>>& faces) {
  std::set<std::vector<int>> known;
  for (const std::vector<int>& face : faces) {
    known.insert(standing(face));
    if (face.size() != 4) continue;
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::vector<int> triangle = face;
      triangle.erase(triangle.begin() + left_out);
      known.insert(standing(std::move(triangle)));
    }
  }
  return known;
}

}  // namespace

std::optional<std::string> foreign_face(const Cage& rest, const Mesh& posed) {
  const bool plane = rest.dimension() == 2;
  std::vector<std::vector<int>> faces = posed.faces;
  if (plane) {
    faces.clear();
    for (const auto& [from, to] : posed.segments) faces.push_back({from, to});
  }
  const std::vector<std::vector<int>> own = faces_of(rest);
  const std::set<std::vector<int>> known = with_triangles(own);
  // A quad of the pose is known by the rest cage's triangles.
  const auto is_made_of_triangles = [&](const std::vector<int>& face) {
    const auto has = [&](int a, int b, int c) { return known.contains(standing({face[a], face[b], face[c]})); };
    return face.size() == 4 && ((has(0, 1, 2) && has(0, 2, 3)) || (has(1, 2, 3) && has(1, 3, 0)));
  };
  // A polygon of the pose is known by the triangles that it was cut in.
  const auto is_cut = [&](const std::vector<int>& face) {
    if (face.size() < 5) return false;
    const std::set<int> corners(face.begin(), face.end());
    const auto parts = std::ranges::count_if(own, [&](const std::vector<int>& part) {
      return std::ranges::all_of(part, [&](int v) { return corners.contains(v); });
    });
    return static_cast<std::size_t>(parts) >= face.size() - 2;
  };
  const std::string_view word = plane ? "segment" : "face";
  // A symmetric cage has the same faces under other numbers: where there are as many, their order tells.
  const bool in_order = faces.size() == own.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool is_known = known.contains(standing(faces[f])) || is_made_of_triangles(faces[f]) || is_cut(faces[f]);
    if (is_known && (!in_order || standing(faces[f]) == standing(own[f]))) continue;
    const std::vector<std::size_t>& lines = plane ? posed.segment_lines : posed.face_lines;
    const std::string line = f < lines.size() ? fmt::format(" (line {})", lines[f]) : "";
    const std::string other = is_known
                                  ? fmt::format("{} {} of {} joins {}", word, f, rest.name(), fmt::join(own[f], ", "))
                                  : fmt::format("no {} of {} does", word, rest.name());
    return fmt::format("{} {}{} joins vertices {}, and {}", word, f, line, fmt::join(faces[f], ", "), other);
  }
  return std::nullopt;
}

}  // namespace cageproof
