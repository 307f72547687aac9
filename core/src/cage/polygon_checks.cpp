// SPDX-License-Identifier: MIT
#include "polygon_checks.h"

#include "cageproof/core/geometry/orientation.h"
#include "connected.h"
#include "geometry/segment_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace cageproof::cage_checks {
namespace {

// Returns, per vertex, the segments that have it, in ascending order.
std::vector<std::vector<int>> segments_at(const std::vector<Face>& segments, std::size_t vertex_count) {
  std::vector<std::vector<int>> at(vertex_count);
  for (std::size_t f = 0; f < segments.size(); ++f)
    for (int k = 0; k < 2; ++k) at[segments[f].vertices[k]].push_back(static_cast<int>(f));
  return at;
}

// Left of it, or below it on the same vertical.
bool is_left_of(const Vec3<double>& p, const Vec3<double>& q) { return p[0] != q[0] ? p[0] < q[0] : p[1] < q[1]; }

std::string both(const Candidate& cage, int first, int second) {
  const auto& lines = cage.options.face_lines;
  if (lines.empty()) return fmt::format("segments {} and {}", first, second);
  return fmt::format("segments {} and {} (lines {} and {})", first, second, lines[first], lines[second]);
}

std::string described(const Candidate& cage, const SegmentContact& contact) {
  using How = SegmentContact::How;
  const std::string pair = both(cage, contact.first, contact.second);
  if (contact.how == How::Cross) return fmt::format("{} cross each other", pair);
  if (contact.how == How::Touch) return fmt::format("{} touch each other, at vertex {}", pair, contact.vertex);
  const std::string spike = contact.vertex < 0 ? "" : fmt::format(": a spike at vertex {}", contact.vertex);
  return fmt::format("{} lie on each other{}", pair, spike);
}

}  // namespace

void check_plane(const Candidate& cage) {
  for (std::size_t f = 0; f < cage.faces.size(); ++f)
    if (cage.faces[f].size() != 2) fail_face(cage, f, "a polygon's elements are segments");
  for (std::size_t i = 0; i < cage.vertices.size(); ++i)
    if (cage.vertices[i][2] != 0)
      fail_vertex(cage, i,
                  fmt::format("3D points for a polygon: its third coordinate is {}, not 0", cage.vertices[i][2]));
}

void check_lengths(const Candidate& cage) {
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const auto& v = cage.faces[f].vertices;
    if (cage.vertices[v[0]] == cage.vertices[v[1]])
      fail_face(cage, f, fmt::format("degenerate: vertices {} and {} coincide", v[0], v[1]));
  }
}

void check_places(const Candidate& cage) {
  std::vector<int> order(cage.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int v, int w) { return is_left_of(cage.vertices[v], cage.vertices[w]); });
  Connected connected(cage.vertices.size());
  for (const Face& segment : cage.faces) connected.join(segment.vertices[0], segment.vertices[1]);
  std::optional<std::pair<int, int>> first;
  // The first vertex of each polygon at one place.
  std::map<int, int> first_of;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int vertex = order[k];
    if (k == 0 || cage.vertices[order[k - 1]] != cage.vertices[vertex]) first_of.clear();
    const auto [found, is_new] = first_of.emplace(connected.root(vertex), vertex);
    const std::pair pair{found->second, vertex};
    if (!is_new) first = first ? std::min(*first, pair) : pair;
  }
  if (first)
    fail_vertex(cage, first->second,
                fmt::format("repeated, it lies where vertex {} does; a closed polyline has one vertex per place, its "
                            "last segment ends at its first vertex",
                            first->first));
}

void check_loops(const Candidate& cage) {
  const auto at = segments_at(cage.faces, cage.vertices.size());
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v].size() == 1) {
      const bool begins = cage.faces[at[v][0]].vertices[0] == static_cast<int>(v);
      fail_vertex(cage, v,
                  fmt::format("the polyline is open: {} {} there, and no other segment has that vertex",
                              face_label(cage, at[v][0]), begins ? "begins" : "ends"));
    }
    if (at[v].size() > 2)
      fail_vertex(cage, v,
                  fmt::format("{} segments meet there: at a polygon's vertex one ends and one begins", at[v].size()));
  }
}

void check_directions(const Candidate& cage) {
  const auto at = segments_at(cage.faces, cage.vertices.size());
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto begins = [&](int k) { return cage.faces[at[v][k]].vertices[0] == static_cast<int>(v); };
    if (begins(0) != begins(1)) continue;
    fail_vertex(cage, v,
                fmt::format("{} both {} there: a polygon's segments follow each other; --flip-inward turns them",
                            both(cage, at[v][0], at[v][1]), begins(0) ? "begin" : "end"));
  }
}

void check_simple(const Candidate& cage) {
  if (const auto contact = first_contact(cage.vertices, cage.faces))
    fail(cage, described(cage, *contact) + " (segments and vertices counted from 0)");
}

int turning(const Candidate& cage, std::span<const int> loop) {
  const auto begin_of = [&](int f) -> const Vec3<double>& { return cage.vertices[cage.faces[f].vertices[0]]; };
  const auto end_of = [&](int f) -> const Vec3<double>& { return cage.vertices[cage.faces[f].vertices[1]]; };
  // A loop turns as it does at its leftmost vertex, which is a corner of its convex hull.
  const int after = *std::ranges::min_element(loop, [&](int f, int g) { return is_left_of(begin_of(f), begin_of(g)); });
  const int before = *std::ranges::find_if(loop, [&](int f) { return end_of(f) == begin_of(after); });
  return -side_of_line({begin_of(before), end_of(before)}, end_of(after));
}

void align_segments(std::vector<Face>& segments, std::size_t vertex_count) {
  const auto at = segments_at(segments, vertex_count);
  std::vector<bool> seen(segments.size(), false);
  for (std::size_t first = 0; first < segments.size(); ++first) {
    for (int f = static_cast<int>(first); !seen[f];) {
      seen[f] = true;
      const int end = segments[f].vertices[1];
      f = at[end][0] == f ? at[end][1] : at[end][0];
      auto& next = segments[f].vertices;
      if (!seen[f] && next[0] != end) std::swap(next[0], next[1]);
    }
  }
}

}  // namespace cageproof::cage_checks
