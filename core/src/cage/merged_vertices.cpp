// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/merged_vertices.h"

#include "cageproof/core/input_error.h"

#include "connected.h"
#include "geometry/meeting_boxes.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof {
namespace {

// A polygon with new numbers, without corners that repeat the one before.
std::vector<int> renumbered(const std::vector<int>& polygon, const Merging& merging) {
  std::vector<int> found;
  for (const int v : polygon)
    if (found.empty() || found.back() != merging.number[v]) found.push_back(merging.number[v]);
  while (found.size() > 1 && found.front() == found.back()) found.pop_back();
  return found;
}

// Keeps the lines of elements that are kept, where there are any.
void keep_line(std::vector<std::size_t>& kept, const std::vector<std::size_t>& lines, std::size_t element) {
  if (element < lines.size()) kept.push_back(lines[element]);
}

}  // namespace

Merging merging_of(const std::vector<Vec3<double>>& vertices, double distance) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(vertices.size());
  const Vec3<double> half = Vec3<double>::Constant(distance / 2);
  for (const Vec3<double>& v : vertices) boxes.emplace_back(v - half, v + half);
  cage_checks::Connected connected(vertices.size());
  for_meeting_boxes(boxes, [&](int a, int b) {
    if (vertices[a] == vertices[b] || (vertices[a] - vertices[b]).stableNorm() <= distance) connected.join(a, b);
    return true;
  });
  Merging merging;
  std::vector<int> new_of(vertices.size(), -1);  // by root
  for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
    int& number = new_of[connected.root(v)];
    if (number < 0) {
      number = static_cast<int>(merging.first.size());
      merging.first.push_back(v);
    }
    merging.number.push_back(number);
  }
  return merging;
}

Mesh merged(Mesh mesh, const Merging& merging, const std::filesystem::path& path) {
  const std::size_t before = mesh.vertices.size(), elements = mesh.faces.size() + mesh.segments.size();
  std::vector<Vec3<double>> vertices;
  vertices.reserve(merging.first.size());
  for (const int v : merging.first) vertices.push_back(mesh.vertices[v]);
  Mesh found;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::vector<int> polygon = renumbered(mesh.faces[f], merging);
    if (polygon.size() < 3) continue;
    found.faces.push_back(std::move(polygon));
    keep_line(found.face_lines, mesh.face_lines, f);
    found.face_numbers.push_back(mesh.face_numbers.empty() ? static_cast<int>(f) : mesh.face_numbers[f]);
  }
  for (std::size_t s = 0; s < mesh.segments.size(); ++s) {
    const auto [from, to] = mesh.segments[s];
    if (merging.number[from] == merging.number[to]) continue;
    found.segments.push_back({merging.number[from], merging.number[to]});
    keep_line(found.segment_lines, mesh.segment_lines, s);
  }
  mesh.vertices = std::move(vertices);
  mesh.faces = std::move(found.faces);
  mesh.face_lines = std::move(found.face_lines);
  mesh.face_numbers = std::move(found.face_numbers);
  mesh.segments = std::move(found.segments);
  mesh.segment_lines = std::move(found.segment_lines);
  const std::size_t lost = elements - mesh.faces.size() - mesh.segments.size();
  mesh.warnings.push_back(
      fmt::format("{}: {} vertices are merged to {}{}", path.string(), before, mesh.vertices.size(),
                  lost == 0 ? ""
                            : fmt::format(", and {} {} without {} left out", lost, lost == 1 ? "element" : "elements",
                                          lost == 1 ? "size is" : "sizes are")));
  return mesh;
}

std::vector<Vec3<double>> merged_pose(const std::vector<Vec3<double>>& posed, const Merging& merging, double distance,
                                      const std::filesystem::path& path) {
  if (posed.size() != merging.number.size())
    throw InputError(fmt::format("{}: {} vertices, the cage has {} before --merge and {} after it", path.string(),
                                 posed.size(), merging.number.size(), merging.first.size()));
  std::vector<Vec3<double>> vertices;
  vertices.reserve(merging.first.size());
  for (const int v : merging.first) vertices.push_back(posed[v]);
  for (std::size_t v = 0; v < posed.size(); ++v) {
    const Vec3<double>& place = vertices[merging.number[v]];
    if (posed[v] != place && !((posed[v] - place).stableNorm() <= distance))
      throw InputError(fmt::format(
          "{}: vertices {} and {} are one in the rest cage by --merge, and lie {:.3g} apart in this pose (vertices "
          "counted from 0)",
          path.string(), merging.first[merging.number[v]], v, (posed[v] - place).stableNorm()));
  }
  return vertices;
}

}  // namespace cageproof
