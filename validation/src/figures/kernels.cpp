// SPDX-License-Identifier: MIT
// [C23] Figure 3: fields that the kernels of an edge and of a vertex make of normals, in the plane.
#include "embedded_figures.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/geometry/winding_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::validation {
namespace {

constexpr std::array<double, 3> kernel_ratios{0, 0.3, 0.45};
constexpr std::array kernel_fields{"Kn", "Kt", "Tn", "Tt"};

// A polygon with an edge and a vertex to look at.
Cage kernel_polygon() {
  std::vector<Vec3<double>> vertices{{0, 0, 0}, {2, -0.3, 0}, {2.6, 1.1, 0}, {1.1, 2.2, 0}, {-0.4, 1.2, 0}};
  std::vector<Face> segments;
  segments.reserve(5);
  for (int k = 0; k < 5; ++k) segments.push_back({{k, (k + 1) % 5, -1, -1}});
  return Cage::make_polygon("pentagon", std::move(vertices), std::move(segments));
}
constexpr int kernel_vertex = 1, kernel_edge = 3;

double distance_in_plane(const Segment<double>& s, const Vec3<double>& point) {
  const Vec3<double> along = s[1] - s[0];
  const double place = std::clamp((point - s[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - s[0] - place * along).norm();
}

// Points inside on a grid, none next to the polygon.
std::vector<Vec3<double>> kernel_points(const Cage& cage) {
  std::vector<Segment<double>> segments;
  for (const Face& face : cage.faces())
    segments.push_back({cage.vertices()[face.vertices[0]], cage.vertices()[face.vertices[1]]});
  std::vector<Vec3<double>> found;
  constexpr double step = 0.1;
  for (double y = -0.25; y < 2.2; y += step)
    for (double x = -0.35; x < 2.6; x += step) {
      const Vec3<double> point(x, y, 0);
      const bool is_beside = std::ranges::any_of(
          segments, [&](const Segment<double>& s) { return distance_in_plane(s, point) < 0.35 * step; });
      if (!is_beside && winding_number(segments, point).value_or(0) != 0) found.push_back(point);
    }
  return found;
}

Vec3<double> outward(const Cage& cage, int edge) {
  const Vec3<double> along =
      cage.vertices()[cage.faces()[edge].vertices[1]] - cage.vertices()[cage.faces()[edge].vertices[0]];
  return Vec3<double>(along[1], -along[0], 0).normalized();
}

class KernelFigure final : public PaperFigure {
 public:
  std::string name() const override { return "kernels"; }
  int parts() const override { return static_cast<int>(kernel_ratios.size()); }

  FigureFindings part(int part, int /*jobs*/) const override {
    const CageCoordinates coordinates(cage_, coordinate_kind_named("somigliana"),
                                      CoordinateOptions{"", Triangulation::Shortest, {1, kernel_ratios[part]}});
    const auto tables = coordinates.at<double>(std::span(points_), 0);
    const Vec3<double> of_edge = outward(cage_, kernel_edge);
    const Vec3<double> of_vertex = (outward(cage_, kernel_vertex - 1) + outward(cage_, kernel_vertex)).normalized();
    FigureFindings found;
    for (std::size_t f = 0; f < kernel_fields.size(); ++f) {
      const bool of_k = f < 2;
      const Vec3<double>& n = of_k ? of_edge : of_vertex;
      const Vec3<double> with = f % 2 == 0 ? n : Vec3<double>(-n[1], n[0], 0);
      const auto& table = tables[of_k ? 1 : 0];
      // Journals keep a mesh's vertices: here the vectors at the points.
      MeshField field;
      field.vertices.reserve(points_.size());
      for (std::size_t p = 0; p < points_.size(); ++p) {
        const double* const m = &table.tensors[0][p * table.stride[0] + 4 * (of_k ? kernel_edge : kernel_vertex)];
        field.vertices.emplace_back(m[0] * with[0] + m[1] * with[1], m[2] * with[0] + m[3] * with[1], 0);
      }
      field.name = key_of(part, f);
      found[field.name] = std::move(field);
    }
    return found;
  }

  bool is_in(const FigureFindings& found) const override {
    for (int part = 0; part < parts(); ++part)
      for (std::size_t f = 0; f < kernel_fields.size(); ++f)
        if (const auto at = found.find(key_of(part, f));
            at == found.end() || at->second.vertices.size() != points_.size())
          return false;
    return true;
  }

  std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const override {
    reports::FigureSheet sheet{.name = "c23-kernels",
                               .heading = "Somigliana kernels in the plane",
                               .source = "[C23] Figure 3",
                               .text =
                                   "The matrices K of one edge and T of one vertex (red) at points of a pentagon, "
                                   "times the edge's normal n (of a vertex, "
                                   "the mean of its edges') and its perpendicular, for three of Poisson's ratios. "
                                   "Arrows show directions, colours how long "
                                   "the vectors are, from dark (short) to yellow (the longest of their panel).",
                               .columns = 4,
                               .view = {},
                               .panels = {}};
    for (int part = 0; part < parts(); ++part)
      for (std::size_t f = 0; f < kernel_fields.size(); ++f) sheet.panels.push_back(drawn(part, f, found));
    return {std::move(sheet)};
  }

 private:
  static std::string key_of(int part, std::size_t field) {
    return fmt::format("figure/c23-kernels/{}.nu{}", kernel_fields[field], kernel_ratios[part]);
  }

  reports::FigurePanel drawn(int part, std::size_t f, const FigureFindings& found) const {
    static constexpr std::array titles{"K n", "K n⊥", "T n", "T n⊥"};
    reports::FigurePanel panel;
    const std::vector<Vec3<double>>& vectors = found.at(key_of(part, f)).vertices;
    panel.data.vertices = points_;
    panel.data.arrays = {{"field", "", 3, {}}};
    for (const Vec3<double>& vector : vectors)
      panel.data.arrays[0].values.insert(panel.data.arrays[0].values.end(), vector.begin(), vector.end());
    panel.title = fmt::format("{},  ν = {}", titles[f], kernel_ratios[part]);
    panel.file = fmt::format("{}.nu{}", kernel_fields[f], kernel_ratios[part]);
    panel.flat = true;
    panel.cage = cage_.vertices();
    for (const Face& face : cage_.faces()) panel.cage_faces.push_back({face.vertices[0], face.vertices[1]});
    const auto& vertices = cage_.vertices();
    if (f < 2)
      panel.marks = {
          (vertices[cage_.faces()[kernel_edge].vertices[0]] + vertices[cage_.faces()[kernel_edge].vertices[1]]) / 2};
    else panel.marks = {vertices[kernel_vertex]};
    double longest = 0;
    for (const Vec3<double>& vector : vectors) longest = std::max(longest, vector.norm());
    for (std::size_t p = 0; p < points_.size(); ++p)
      panel.arrows.push_back({points_[p], 0.05 * vectors[p].normalized(), vectors[p].norm() / longest});
    panel.note = fmt::format("up to {:.3f}", longest);
    panel.facts = {
        {"kernel", titles[f]}, {"parameters", fmt::format("mu=1 nu={}", kernel_ratios[part])}, {"cage", cage_.name()}};
    panel.measured = {{"largest", longest}};
    return panel;
  }

  Cage cage_ = kernel_polygon();
  std::vector<Vec3<double>> points_ = kernel_points(cage_);
};

}  // namespace

std::unique_ptr<const PaperFigure> kernel_figure() { return std::make_unique<KernelFigure>(); }

}  // namespace cageproof::validation
