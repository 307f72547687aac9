// SPDX-License-Identifier: MIT
#include "cage_parts.h"

#include "cage_edges.h"
#include "connected.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/geometry/element.h"
#include "face_crossings.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/geometry/winding_number.h"
#include "face_pieces.h"
#include "geometry/segment_contacts.h"
#include "polygon_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ranges>

namespace cageproof::cage_checks {
namespace {

// With the cage's name in the error.
std::vector<FaceCrossing> crossings_of(const Candidate& cage) {
  try {
    return face_crossings(cage.vertices, cage.faces);
  } catch (const InputError& error) {
    fail(cage, error.what());
  }
}

// One entry per face: surfaces in space, loops in the plane.
std::vector<int> part_numbers(const Candidate& cage) {
  if (!is_plane(cage)) return surfaces_of(cage.vertices, cage.faces);
  Connected connected(cage.vertices.size());
  for (const Face& segment : cage.faces) connected.join(segment.vertices[0], segment.vertices[1]);
  std::vector<int> numbers;
  numbers.reserve(cage.faces.size());
  for (const Face& segment : cage.faces) numbers.push_back(connected.root(segment.vertices[0]));
  return numbers;
}

std::vector<Part> connected_parts(const Candidate& cage) {
  const std::vector<int> numbers = part_numbers(cage);
  std::vector<Part> parts;
  std::map<int, int> part_of;  // by number
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const auto [part, added] = part_of.try_emplace(numbers[f], static_cast<int>(parts.size()));
    if (added) parts.emplace_back();
    parts[part->second].faces.push_back(static_cast<int>(f));
  }
  return parts;
}

// Whether a point lies within a segment.
bool is_between(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& point) {
  return side_of_line({a, b}, point) == 0 && (a.cwiseMin(b).array() <= point.array()).all() &&
         (a.cwiseMax(b).array() >= point.array()).all();
}

// The region that a part encloses, which can be asked for points.
class Region {
 public:
  Region(const Candidate& cage, const Part& part) : cage_(cage), orientation_(part.orientation) {
    for (const int f : part.faces) {
      const auto& v = cage.faces[f].vertices;
      const auto at = [&](int k) { return cage.vertices[v[k]]; };
      for (int k = 0; k < cage.faces[f].size(); ++k) vertices_.push_back(v[k]);
      if (cage.faces[f].size() == 2) segments_.push_back({at(0), at(1)});
      else
        for (const auto& [a, b, c] : pieces_of(cage.vertices, cage.faces[f]))
          triangles_.push_back({cage.vertices[a], cage.vertices[b], cage.vertices[c]});
    }
    std::ranges::sort(vertices_);
    const auto repeated = std::ranges::unique(vertices_);
    vertices_.erase(repeated.begin(), repeated.end());
    box_ = box_of(std::views::transform(vertices_, [&](int v) -> const Vec3<double>& { return cage.vertices[v]; }));
  }

  /// \param crossing whether their faces cross or touch: else one vertex answers for all
  bool holds(const Region& other, bool crossing) const {
    if ((other.box_.low.array() < box_.low.array()).any() || (other.box_.high.array() > box_.high.array()).any())
      return false;
    bool any = false;
    for (const int v : other.vertices_) {
      const auto winding = segments_.empty() ? winding_number(triangles_, cage_.vertices[v])
                                             : winding_number(segments_, cage_.vertices[v]);
      if (!winding) continue;
      if (*winding == 0) return false;
      any = true;
      if (!crossing) break;
    }
    return any || (!segments_.empty() && holds_touching(other));
  }

 private:
  // All vertices of the other polygon lie on this one: it sets out to one of its sides.
  bool holds_touching(const Region& other) const {
    const auto& [from, to] = other.segments_.front();
    Passage way{from, from, from};
    for (const auto& [a, b] : segments_) {
      if (b == from) way.before = a;
      else if (a == from) way.after = b;
      else if (way.before == from && way.after == from && is_between(a, b, from)) way = {a, from, b};
    }
    return is_left(way, to) == (orientation_ > 0);
  }

  const Candidate& cage_;
  int orientation_;
  std::vector<int> vertices_;
  std::vector<Triangle<double>> triangles_;
  std::vector<Segment<double>> segments_;
  Box box_;
};

// Pairs of parts whose faces cross or touch, the lower one first.
std::vector<std::pair<int, int>> crossing_parts(const Candidate& cage, const std::vector<Part>& parts) {
  std::vector<int> part_of(cage.faces.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const int f : parts[p].faces) part_of[f] = static_cast<int>(p);
  std::vector<std::pair<int, int>> pairs;
  for (const FaceCrossing& c : crossings_of(cage)) pairs.push_back(std::minmax({part_of[c.first], part_of[c.second]}));
  std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  pairs.erase(repeated.begin(), repeated.end());
  return pairs;
}

void nest(const Candidate& cage, std::vector<Part>& parts) {
  std::vector<Region> regions;
  regions.reserve(parts.size());
  for (const Part& part : parts) regions.emplace_back(cage, part);
  // Polygons do not cross.
  const auto crossings = is_plane(cage) ? std::vector<std::pair<int, int>>() : crossing_parts(cage, parts);
  const int count = static_cast<int>(parts.size());
  for (int inner = 0; inner < count; ++inner)
    for (int outer = 0; outer < count; ++outer) {
      if (inner == outer) continue;
      const bool crossing = std::ranges::binary_search(crossings, std::minmax({inner, outer}));
      if (regions[outer].holds(regions[inner], crossing)) parts[inner].around.push_back(outer);
    }
}

std::string label(const Candidate& cage, const Part& part) {
  return fmt::format("the part of {} {} from {} on", part.faces.size(), is_plane(cage) ? "segments" : "faces",
                     face_label(cage, part.faces.front()));
}

}  // namespace

std::vector<Part> parts_of(const Candidate& cage) {
  std::vector<Part> parts = connected_parts(cage);
  for (Part& part : parts) {
    part.orientation = is_plane(cage) ? turning(cage, part.faces) : orientation(cage, part.faces);
    if (part.orientation == 0)
      throw InputError(
          fmt::format("{}: {} encloses no volume", cage.name, parts.size() == 1 ? "the cage" : label(cage, part)));
  }
  if (parts.size() > 1) nest(cage, parts);
  return parts;
}

std::string wrong_way(const Candidate& cage, const std::vector<Part>& parts, const Part& part) {
  const std::string_view inward = is_plane(cage) ? "run clockwise (negative area)" : "point inward (negative volume)";
  const std::string_view elements = is_plane(cage) ? "segments" : "faces";
  if (std::ranges::all_of(parts, [](const Part& p) { return p.orientation != p.expected(); }))
    return fmt::format("{}: the {} {}, from {} on; --flip-inward reverses them", cage.name, elements, inward,
                       face_label(cage, 0));
  const std::string where =
      part.around.empty()
          ? "within no other part"
          : fmt::format("within {} other part{}, the first from {} on", part.around.size(),
                        part.around.size() == 1 ? "" : "s", face_label(cage, parts[part.around.front()].faces.front()));
  const bool plane = is_plane(cage);
  const std::string_view how = part.orientation < 0 ? (plane ? "bounds no hole, though it runs clockwise"
                                                             : "bounds no cavity, though its normals point inward")
                                                    : (plane ? "bounds a hole, so it should run clockwise"
                                                             : "bounds a cavity, so its normals should point into it");
  return fmt::format("{}: {} lies {}: it {}; --flip-inward reverses such parts", cage.name, label(cage, part), where,
                     how);
}

}  // namespace cageproof::cage_checks
