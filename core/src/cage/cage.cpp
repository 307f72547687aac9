// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/cage/cage.h"

#include "cageproof/core/geometry/element.h"
#include "face_crossings.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/quad_geometry.h"
#include "cage_checks.h"
#include "cage_edges.h"
#include "cage_parts.h"
#include "face_pieces.h"
#include "polygon_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace cageproof {
namespace {

// Turns the parts that face the wrong way, or throws.
void orient_parts(const cage_checks::Candidate& cage, std::vector<Face>& faces, bool flip_inward) {
  const std::vector<cage_checks::Part> parts = cage_checks::parts_of(cage);
  for (const cage_checks::Part& part : parts) {
    if (part.orientation == part.expected()) continue;
    if (!flip_inward) throw InputError(cage_checks::wrong_way(cage, parts, part));
    for (const int f : part.faces) {
      // The first corner of triangles and quads stays, so that Triangulation::Fan keeps its diagonal.
      const bool segment = faces[f].size() == 2;
      std::reverse(faces[f].vertices.begin() + (segment ? 0 : 1), faces[f].vertices.begin() + faces[f].size());
    }
  }
}

}  // namespace

ElementKind Face::kind() const { return kind_with_corners(size()); }

std::string_view name_of(Triangulation rule) { return rule == Triangulation::Shortest ? "shortest" : "fan"; }

Cage Cage::make(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> faces, CageOptions options) {
  const cage_checks::Candidate candidate{name, vertices, faces, options};
  cage_checks::check_coordinates(candidate);
  cage_checks::check_indices(candidate);
  cage_checks::check_shapes(candidate, options.allow_invalid_quads);
  cage_checks::check_edges(candidate);
  orient_parts(candidate, faces, options.flip_inward);
  Cage cage;
  cage.name_ = std::move(name);
  cage.vertices_ = std::move(vertices);
  cage.faces_ = std::move(faces);
  cage.face_lines_ = std::move(options.face_lines);
  cage.face_numbers_ = std::move(options.face_numbers);
  cage.allows_invalid_quads_ = options.allow_invalid_quads;
  return cage;
}

Cage Cage::make_polygon(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> segments,
                        CageOptions options) {
  return polygon(std::move(name), std::move(vertices), std::move(segments), std::move(options), true);
}

Cage Cage::polygon(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> segments,
                   CageOptions options, bool look_for_contacts) {
  const cage_checks::Candidate candidate{name, vertices, segments, options, 2};
  cage_checks::check_coordinates(candidate);
  cage_checks::check_plane(candidate);
  cage_checks::check_indices(candidate);
  cage_checks::check_lengths(candidate);
  if (look_for_contacts) cage_checks::check_places(candidate);
  cage_checks::check_loops(candidate);
  if (options.flip_inward) cage_checks::align_segments(segments, vertices.size());
  cage_checks::check_directions(candidate);
  if (look_for_contacts) cage_checks::check_simple(candidate);
  orient_parts(candidate, segments, options.flip_inward);
  Cage cage;
  cage.dimension_ = 2;
  cage.name_ = std::move(name);
  cage.vertices_ = std::move(vertices);
  cage.faces_ = std::move(segments);
  cage.face_lines_ = std::move(options.face_lines);
  return cage;
}

Cage Cage::with(std::vector<Vec3<double>> vertices, std::vector<Face> faces) const {
  const CageOptions options{.allow_invalid_quads = allows_invalid_quads_};
  return dimension_ == 2 ? polygon(name_, std::move(vertices), std::move(faces), options, false)
                         : make(name_, std::move(vertices), std::move(faces), options);
}

std::string Cage::face_label(std::size_t f) const {
  const std::string line = f < face_lines_.size() ? fmt::format(" (line {})", face_lines_[f]) : "";
  return fmt::format("face {}{}", face_number(f), line);
}

Cage::Parts Cage::parts(bool keep_quads, Triangulation rule) const {
  Parts parts;
  if (keep_quads || !has_quads()) {
    parts.elements = faces_;
    for (std::size_t f = 0; f < faces_.size(); ++f) parts.face_of.push_back(static_cast<int>(f));
    return parts;
  }
  Triangles split = triangulate(rule);
  for (const auto& t : split.triangles) parts.elements.push_back({{t[0], t[1], t[2], -1}});
  parts.face_of = std::move(split.face_of);
  return parts;
}

std::array<Vec3<double>, 4> Cage::quad(std::size_t f) const {
  const auto& v = faces_[f].vertices;
  return {vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], vertices_[v[3]]};
}

std::vector<std::string> invalid_quads(const Cage& cage) {
  std::vector<std::string> faults;
  for (std::size_t f = 0; f < cage.faces().size(); ++f) {
    if (cage.faces()[f].size() != 4) continue;
    const auto reason = invalid_because(cage.quad(f));
    if (!reason) continue;
    faults.push_back(fmt::format("{}: {}", cage.face_label(f), *reason));
  }
  return faults;
}

std::optional<std::string> folding_warning(const Cage& cage) {
  std::vector<std::string> found;
  for (std::size_t f = 0; f < cage.faces().size(); ++f) {
    const auto splits = type_of(cage.faces()[f].kind()).splits;
    if (splits.empty() || !std::ranges::all_of(splits, [&](const ElementSplit& split) {
          return folds(cage.vertices(), cage.faces()[f], split);
        }))
      continue;
    found.push_back(cage.face_label(f));
  }
  if (found.empty()) return std::nullopt;
  return fmt::format(
      "{}: {} of its quads fold along either diagonal, {} the first; kinds that split quads take the "
      "shorter diagonal there, and one triangle is turned inside out",
      cage.name(), found.size(), found.front());
}

std::optional<std::string> meeting_warning(const Cage& cage) {
  if (cage.dimension() == 2) return std::nullopt;
  const cage_checks::Meetings found = cage_checks::meetings_of(cage.faces(), cage.vertices().size());
  std::vector<std::string> named;
  if (!found.edges.empty())
    named.push_back(fmt::format("{} {} (the first between vertices {} and {})", found.edges.size(),
                                found.edges.size() == 1 ? "edge" : "edges", found.edges[0].first,
                                found.edges[0].second));
  if (!found.vertices.empty())
    named.push_back(fmt::format("{} {} (the first is {})", found.vertices.size(),
                                found.vertices.size() == 1 ? "vertex" : "vertices", found.vertices[0]));
  if (named.empty()) return std::nullopt;
  return fmt::format(
      "{}: parts of the surface meet in {}: not a manifold; coordinates exist, as for the same surface "
      "with one vertex per part there, and a pose moves the parts together (vertices counted from 0)",
      cage.name(), fmt::join(named, " and "));
}

std::vector<std::string> crossing_faces(const Cage& cage) {
  std::vector<std::string> found;
  if (cage.dimension() == 2) return found;
  const auto& lines = cage.face_lines();
  for (const FaceCrossing& c : face_crossings(cage.vertices(), cage.faces()))
    found.push_back(
        fmt::format("faces {} and {}{}", cage.face_number(c.first), cage.face_number(c.second),
                    lines.empty() ? "" : fmt::format(" (lines {} and {})", lines[c.first], lines[c.second])));
  return found;
}

std::optional<std::string> crossing_warning(const Cage& cage) {
  constexpr std::size_t most = 10;
  const std::vector<std::string> found = crossing_faces(cage);
  if (found.empty()) return std::nullopt;
  const auto shown = std::span(found).first(std::min(most, found.size()));
  const std::string more = found.size() > most ? fmt::format(", and {} more pairs,", found.size() - most) : "";
  return fmt::format(
      "{}: {}{} cross or touch each other; where a cage overlaps itself, coordinates that are not "
      "normalised sum to how often it winds around the point",
      cage.name(), fmt::join(shown, ", "), more);
}

bool Cage::has_quads() const {
  return std::ranges::any_of(faces_, [](const Face& face) { return !type_of(face.kind()).splits.empty(); });
}

double Cage::size() const {
  const auto [low, high] = box_of(vertices_);
  return (high - low).stableNorm();
}

Cage::Triangles Cage::triangulate(Triangulation rule) const {
  Triangles result;
  const auto add = [&](std::size_t face, const std::array<int, 3>& corners) {
    const auto& vertex = faces_[face].vertices;
    result.triangles.push_back({vertex[corners[0]], vertex[corners[1]], vertex[corners[2]]});
    result.face_of.push_back(static_cast<int>(face));
  };
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (type_of(faces_[f].kind()).splits.empty()) {
      add(f, {0, 1, 2});
      continue;
    }
    for (const auto& triangle : split_of(vertices_, faces_[f], rule).triangles) add(f, triangle);
  }
  return result;
}

}  // namespace cageproof
