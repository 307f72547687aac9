// SPDX-License-Identifier: MIT
#include "cage_checks.h"

#include "cage_edges.h"

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/geometry/orientation.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cageproof::cage_checks {
namespace {

void check_shape(const Candidate& cage, std::size_t index) {
  const Face& face = cage.faces[index];
  const int n = face.size();
  std::array<Triangle<double>, 4> at_corner;
  for (int k = 0; k < n; ++k) {
    const int vertex = face.vertices[k], before = face.vertices[(k + n - 1) % n], after = face.vertices[(k + 1) % n];
    at_corner[k] = {cage.vertices[before], cage.vertices[vertex], cage.vertices[after]};
    if (cage.vertices[vertex] == cage.vertices[after])
      fail_face(cage, index, fmt::format("degenerate: vertices {} and {} coincide", vertex, after));
    if (on_a_line(at_corner[k]))
      fail_face(cage, index, fmt::format("degenerate: vertices {}, {} and {} lie on a line", before, vertex, after));
  }
  // The diagonal from corner 0 leaves the triangles at corners 1 and 3, the other one those at 0 and 2.
  if (n == 4 && sign_of_normals(at_corner[1], at_corner[3]) < 0 && sign_of_normals(at_corner[0], at_corner[2]) < 0)
    fail_face(cage, index,
              "the quad crosses itself (a bow-tie), or folds by more than a right angle along both diagonals");
}

// The end of a message that gives numbers of faces.
std::string counted(const Candidate& cage) {
  return fmt::format("({} and vertices counted from 0)", is_plane(cage) ? "segments" : "faces");
}

}  // namespace

void fail(const Candidate& cage, const std::string& reason) { throw InputError(cage.name + ": " + reason); }

void fail_face(const Candidate& cage, std::size_t face, const std::string& reason) {
  fail(cage, fmt::format("{}: {} {}", face_label(cage, face), reason, counted(cage)));
}

void fail_vertex(const Candidate& cage, std::size_t vertex, const std::string& reason) {
  fail(cage, fmt::format("vertex {}: {} {}", vertex, reason, counted(cage)));
}

std::string face_label(const Candidate& cage, std::size_t face) {
  const std::string_view element = is_plane(cage) ? "segment" : "face";
  const CageOptions& known = cage.options;
  const int number = known.face_numbers.empty() ? static_cast<int>(face) : known.face_numbers[face];
  return face < known.face_lines.size() ? fmt::format("{} {} (line {})", element, number, known.face_lines[face])
                                        : fmt::format("{} {}", element, number);
}

void check_coordinates(const Candidate& cage) {
  if (cage.vertices.empty()) fail(cage, "no vertices");
  if (cage.faces.empty()) fail(cage, is_plane(cage) ? "no segments" : "no faces");
  for (std::size_t i = 0; i < cage.vertices.size(); ++i)
    if (!cage.vertices[i].allFinite()) fail_vertex(cage, i, "a coordinate is not finite");
}

void check_indices(const Candidate& cage) {
  const int count = static_cast<int>(cage.vertices.size());
  std::vector<bool> used(count, false);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const Face& face = cage.faces[f];
    for (int k = 0; k < 4; ++k) {
      const int vertex = face.vertices[k];
      if (k >= cage.least_corners && vertex == -1) continue;
      if (vertex < 0 || vertex >= count)
        fail_face(cage, f, fmt::format("index {} is out of range, there are {} vertices", vertex, count));
      if (std::find(face.vertices.begin(), face.vertices.begin() + k, vertex) != face.vertices.begin() + k)
        fail_face(cage, f, fmt::format("vertex {} occurs twice", vertex));
      used[vertex] = true;
    }
  }
  const auto loose = std::ranges::find(used, false);
  if (loose != used.end())
    fail_vertex(cage, loose - used.begin(),
                fmt::format("no {} uses it; remove it from the cage", is_plane(cage) ? "segment" : "face"));
}

void check_shapes(const Candidate& cage, bool allow_invalid_quads) {
  for (std::size_t f = 0; f < cage.faces.size(); ++f)
    if (!allow_invalid_quads || type_of(cage.faces[f].kind()).splits.empty()) check_shape(cage, f);
}

namespace {

// Why an edge may have no other face: vertices that lie in one place, as where each face has its own.
std::string hole_because(const Candidate& cage) {
  std::map<std::array<double, 3>, std::size_t> first;
  std::string named;
  std::size_t more = 0;
  for (std::size_t v = 0; v < cage.vertices.size(); ++v) {
    const Vec3<double>& p = cage.vertices[v];
    const auto [at, added] = first.try_emplace({p[0], p[1], p[2]}, v);
    if (added) continue;
    if (named.empty()) named = fmt::format("vertices {} and {} lie in one place", at->second, v);
    else ++more;
  }
  if (named.empty()) return "the cage has a hole";
  const std::string others = more > 0 ? fmt::format(", and so do {} more", more) : "";
  return fmt::format(
      "{}{}: join them where the file was written (\"merge by distance\", \"weld\"), "
      "or with --merge 0",
      named, others);
}

// Two faces with the same vertices that run along an edge the same way.
void check_no_face_twice(const Candidate& cage, std::span<const EdgeUse> edge) {
  std::map<std::pair<int, std::array<int, 4>>, int> face_of;  // by way and sorted vertices
  for (const EdgeUse& use : edge) {
    std::array<int, 4> sorted = cage.faces[use.face].vertices;
    std::ranges::sort(sorted);
    const auto [found, is_new] = face_of.try_emplace({use.way, sorted}, use.face);
    if (!is_new)
      fail_face(cage, use.face,
                fmt::format("has the vertices of {}, turned the same way: it is there twice",
                            face_label(cage, found->second)));
  }
}

}  // namespace

void check_edges(const Candidate& cage) {
  const auto by_face = [](const EdgeUse& use) { return std::pair(use.face, use.corner); };
  std::span<const EdgeUse> fault;  // of the first face that has one
  EdgeUse first{};
  const std::vector<EdgeUse> uses = edge_uses(cage.faces);
  for_each_edge_of(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() > 2) check_no_face_twice(cage, edge);
    if (edge.size() > 1 && balance(edge) == 0) return;
    const EdgeUse at = *std::ranges::min_element(edge, {}, by_face);
    if (!fault.empty() && by_face(first) < by_face(at)) return;
    fault = edge;
    first = at;
  });
  if (fault.empty()) return;
  const auto [from, to] = first.way > 0 ? std::pair(first.low, first.high) : std::pair(first.high, first.low);
  const std::string edge = fmt::format("edge between vertices {} and {}", from, to);
  const auto fails = [&](const std::string& reason) { fail_face(cage, first.face, edge + reason); };
  if (fault.size() == 1) fails(fmt::format(" belongs to no other face: {}", hole_because(cage)));
  if (fault.size() == 2) fails(" runs the same way in its neighbour: the faces are oriented inconsistently");
  const auto same = std::ranges::count(fault, first.way, &EdgeUse::way);
  fails(
      fmt::format(" belongs to {} faces, of which {} run along it this way and {} the other: not a manifold, and the "
                  "surface is not closed there",
                  fault.size(), same, fault.size() - same));
}

int orientation(const Candidate& cage, std::span<const int> faces) {
  std::vector<Triangle<double>> triangles;
  for (const int f : faces) {
    const auto& vertices = cage.faces[f].vertices;
    const auto add = [&](int a, int b, int c) {
      triangles.push_back({cage.vertices[vertices[a]], cage.vertices[vertices[b]], cage.vertices[vertices[c]]});
    };
    // Twice a bilinear quad's volume is the sum over both of its splits: twice everything.
    const auto splits = type_of(cage.faces[f].kind()).splits;
    if (splits.empty())
      for (int twice = 0; twice < 2; ++twice) add(0, 1, 2);
    for (const ElementSplit& split : splits)
      for (const auto& t : split.triangles) add(t[0], t[1], t[2]);
  }
  return sign_of_volume(triangles);
}

}  // namespace cageproof::cage_checks
