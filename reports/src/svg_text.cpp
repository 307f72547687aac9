// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>

namespace cageproof::reports {
namespace {

// Segments that follow each other are one polyline.
std::vector<std::vector<int>> polylines_of(const Mesh& mesh) {
  std::vector<std::vector<int>> lines;
  for (const auto& [from, to] : mesh.segments) {
    const bool follows = !lines.empty() && lines.back().back() == from &&
                         (lines.back().size() < 3 || lines.back().back() != lines.back().front());
    if (!follows) lines.push_back({from});
    lines.back().push_back(to);
  }
  return lines;
}

// As shortest decimals read it back; zero has no sign.
std::string point_in_svg(const Vec3<double>& p) { return fmt::format("{} {}", p[0], p[1] == 0 ? 0 : -p[1]); }

}  // namespace

std::string svg_text(const Mesh& mesh) {
  if (mesh.segments.empty()) throw InputError("no polylines: .svg files hold polygons; use .obj or .csv");
  std::vector<char> drawn(mesh.vertices.size(), 0);
  for (const auto& [from, to] : mesh.segments) drawn[from] = drawn[to] = 1;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v][2] != 0)
      throw InputError(
          fmt::format("vertex {}: z is {}: .svg files hold polygons of the plane; use .obj or .ply "
                      "(vertices counted from 0)",
                      v, mesh.vertices[v][2]));
    if (!drawn[v])
      throw InputError(
          fmt::format("vertex {} belongs to no polyline: .svg files would lose it; use .obj or .csv "
                      "(vertices counted from 0)",
                      v));
  }
  const auto [low, high] = box_of(mesh.vertices);
  const double width = high[0] - low[0], height = high[1] - low[1];
  std::string text = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {}\">\n",
                                 point_in_svg({low[0], high[1], 0}), width, height);
  for (const std::vector<int>& line : polylines_of(mesh)) {
    const bool closed = line.size() > 2 && line.front() == line.back();
    text += "<path fill=\"none\" stroke=\"black\" vector-effect=\"non-scaling-stroke\" d=\"M ";
    for (std::size_t k = 0; k + (closed ? 1 : 0) < line.size(); ++k)
      text += (k == 0 ? "" : " L ") + point_in_svg(mesh.vertices[line[k]]);
    text += closed ? " Z\"/>\n" : "\"/>\n";
  }
  return text + "</svg>\n";
}

}  // namespace cageproof::reports
