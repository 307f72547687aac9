// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/posed_faces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
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

// The faces of the rest cage, to recognise a pose's faces that are in another order or cut otherwise.
class KnownFaces {
 public:
  explicit KnownFaces(const std::vector<std::vector<int>>& own) : own_(own), known_(with_triangles(own)) {
    for (std::size_t f = 0; f < own.size(); ++f)
      for (const int v : own[f]) faces_at_[v].push_back(f);
  }
  bool has(const std::vector<int>& face) const { return known_.contains(standing(face)) || is_made_of_parts(face); }

 private:
  // A quad or a polygon of the pose, by the cage's triangles that have its corners only.
  bool is_made_of_parts(const std::vector<int>& face) const {
    const std::set<int> corners(face.begin(), face.end());
    std::set<std::size_t> parts;
    for (const int v : corners)
      if (const auto at = faces_at_.find(v); at != faces_at_.end())
        for (const std::size_t f : at->second)
          if (std::ranges::all_of(own_[f], [&](int w) { return corners.contains(w); })) parts.insert(f);
    return face.size() >= 4 && parts.size() >= face.size() - 2;
  }

  const std::vector<std::vector<int>>& own_;
  std::set<std::vector<int>> known_;
  std::map<int, std::vector<std::size_t>> faces_at_;
};

}  // namespace

std::optional<std::string> foreign_face(const Cage& rest, const Mesh& posed) {
  // Another number of vertices is a mistake of its own.
  if (posed.vertices.size() != rest.vertices().size()) return std::nullopt;
  const bool plane = rest.dimension() == 2;
  std::vector<std::vector<int>> segments;
  if (plane) {
    segments.reserve(posed.segments.size());
    for (const auto& [from, to] : posed.segments) segments.push_back({from, to});
  }
  const std::vector<std::vector<int>>&faces = plane ? segments : posed.faces, own = faces_of(rest);
  const std::string_view word = plane ? "segment" : "face";
  // A symmetric cage has the same faces under other numbers: where there are as many, their order tells.
  const bool in_order = faces.size() == own.size();
  std::optional<KnownFaces> known;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (in_order && standing(faces[f]) == standing(own[f])) continue;
    if (!known) known.emplace(own);
    const bool is_known = known->has(faces[f]);
    if (is_known && !in_order) continue;
    const std::vector<std::size_t>& lines = plane ? posed.segment_lines : posed.face_lines;
    const std::string line = f < lines.size() ? fmt::format(" (line {})", lines[f]) : "";
    const std::string other =
        is_known ? fmt::format("{} {} of {} joins {}", word, plane ? static_cast<int>(f) : rest.face_number(f),
                               rest.name(), fmt::join(own[f], ", "))
                 : fmt::format("no {} of {} does", word, rest.name());
    return fmt::format("{} {}{} joins vertices {}, and {}", word, f, line, fmt::join(faces[f], ", "), other);
  }
  return std::nullopt;
}

}  // namespace cageproof
