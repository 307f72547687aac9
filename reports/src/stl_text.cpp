// SPDX-License-Identifier: MIT
#include "cageproof/core/input_error.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cageproof::reports {
namespace {

using FloatVertex = std::array<float, 3>;

FloatVertex in_single_precision(const Mesh& mesh, int vertex) {
  FloatVertex found{};
  for (int i = 0; i < 3; ++i) {
    found[i] = static_cast<float>(mesh.vertices[vertex][i]);
    if (!std::isfinite(found[i]))
      throw InputError(
          fmt::format("vertex {}: {} is beyond single precision, which .stl files have; use .obj or .ply "
                      "(vertices counted from 0)",
                      vertex, mesh.vertices[vertex][i]));
  }
  return found;
}

}  // namespace

std::string stl_text(const Mesh& mesh) {
  static_assert(std::endian::native == std::endian::little);
  if (mesh.faces.empty()) throw InputError("no faces: .stl files hold triangles; use .obj or .csv");
  if (mesh.faces.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("{} triangles: .stl files hold at most 2^32 - 1", mesh.faces.size()));
  std::string text(80, ' ');
  text.reserve(84 + 50 * mesh.faces.size());
  const auto append = [&](const auto& x) { text.append(reinterpret_cast<const char*>(&x), sizeof x); };
  append(static_cast<std::uint32_t>(mesh.faces.size()));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    if (face.size() != 3)
      throw InputError(
          fmt::format("face {} has {} corners: .stl files hold triangles; use .obj or .ply (faces counted "
                      "from 0)",
                      f, face.size()));
    const Vec3<double>& at = mesh.vertices[face[0]];
    const Vec3<double> normal =
        (mesh.vertices[face[1]] - at).stableNormalized().cross((mesh.vertices[face[2]] - at).stableNormalized());
    const Vec3<double> unit = normal.stableNormalized();
    for (const double x : unit) append(std::isfinite(x) ? static_cast<float>(x) : 0.0F);
    for (const int v : face) append(in_single_precision(mesh, v));
    append(std::uint16_t{0});
  }
  return text;
}

}  // namespace cageproof::reports
