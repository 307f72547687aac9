// SPDX-License-Identifier: MIT
#include "cageproof/reports/mesh_text.h"

#include "cageproof/core/cage/face_triangles.h"
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cageproof::reports {
namespace {

using StlCorner = std::array<float, 3>;

// A mesh's triangles, by vertex.
struct StlTriangles {
  std::vector<std::array<int, 3>> corners;
  std::size_t uncut = 0, first_uncut = 0;  // faces that triangles_of_face does not cut
};

StlTriangles triangles_of(const Mesh& mesh) {
  StlTriangles found;
  std::vector<Vec3<double>> corners;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    corners.clear();
    for (const int v : face) corners.push_back(mesh.vertices[v]);
    auto triangles = triangles_of_face(corners);
    if (triangles.empty()) {
      if (found.uncut++ == 0) found.first_uncut = f;
      for (int k = 1; k + 1 < static_cast<int>(face.size()); ++k) triangles.push_back({0, k, k + 1});
    }
    for (const auto& t : triangles) found.corners.push_back({face[t[0]], face[t[1]], face[t[2]]});
  }
  return found;
}

StlCorner in_single_precision(const Mesh& mesh, int vertex) {
  StlCorner corner;
  for (int i = 0; i < 3; ++i) {
    const double x = mesh.vertices[vertex][i];
    corner[i] = static_cast<float>(x);
    if (!std::isfinite(corner[i]))
      throw InputError(
          fmt::format("vertex {} (counted from 0): {} is beyond single precision, which STL has; write "
                      "PLY or OBJ, or a smaller mesh",
                      vertex, x));
  }
  return corner;
}

// Takes the corners as they are written; differences and products of such numbers neither overflow nor underflow.
StlCorner normal_of(const std::array<StlCorner, 3>& corners) {
  Triangle<double> t;
  for (int k = 0; k < 3; ++k) t[k] = Vec3<double>(corners[k][0], corners[k][1], corners[k][2]);
  if (on_a_line(t)) return {0, 0, 0};
  const Vec3<double> normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return {static_cast<float>(normal[0]), static_cast<float>(normal[1]), static_cast<float>(normal[2])};
}

template <class T>
void append_bytes(std::string& bytes, const T& x) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
}

}  // namespace

PartialMeshText stl_text(const Mesh& mesh) {
  if (mesh.faces.empty()) throw InputError("no faces, and STL holds only faces");
  const StlTriangles triangles = triangles_of(mesh);
  if (triangles.corners.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("{} triangles, more than the 4294967295 that STL counts", triangles.corners.size()));
  // Readers take files that begin with "solid" for text.
  constexpr std::size_t header = 80, record = 50;
  PartialMeshText made{"binary STL, written by cageproof"};
  std::string& bytes = made.text;
  bytes.reserve(header + 4 + record * triangles.corners.size());
  bytes.resize(header, '\0');
  append_bytes(bytes, static_cast<std::uint32_t>(triangles.corners.size()));
  std::vector<char> used(mesh.vertices.size(), 0);
  bool rounds = false;
  for (const auto& vertices : triangles.corners) {
    std::array<StlCorner, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const int v = vertices[k];
      corners[k] = in_single_precision(mesh, v);
      used[v] = 1;
      for (int i = 0; i < 3; ++i) rounds |= corners[k][i] != mesh.vertices[v][i];
    }
    append_bytes(bytes, normal_of(corners));
    append_bytes(bytes, corners);
    append_bytes(bytes, std::uint16_t{0});
  }
  if (const auto unused = std::ranges::count(used, 0); unused > 0)
    made.left_out.push_back(fmt::format("{} vertices of no face", unused));
  if (!mesh.segments.empty()) made.left_out.emplace_back("polylines");
  if (rounds) made.changed.emplace_back("STL is single precision: coordinates are rounded to about 7 digits");
  if (triangles.uncut > 0)
    made.changed.push_back(
        fmt::format("{} faces have boundaries that cross or touch themselves or have no area, and are cut in triangles "
                    "about their first corner; the first of them is face {} (counted from 0)",
                    triangles.uncut, triangles.first_uncut));
  return made;
}

}  // namespace cageproof::reports
