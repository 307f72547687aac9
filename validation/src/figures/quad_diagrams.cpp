// SPDX-License-Identifier: MIT
// [T18] Figures 5, 8 and 9: single bilinear quads, which are valid, and where the paper's scheme samples them.
#include "bilinear_surface.h"
#include "embedded_figures.h"

#include "cageproof/core/catalogue/steps.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cageproof::validation {
namespace {

// A quad's border, with corners lifted by `lift` in turn up and down.
Quad<double> saddle(double lift) { return {{{-1, -1, lift}, {1, -1, -lift}, {1, 1, lift}, {-1, 1, -lift}}}; }

struct NamedQuad {
  std::string file, title;
  Quad<double> quad;
};

std::vector<NamedQuad> quads_to_judge() {
  return {{"convex", "planar and convex", saddle(0)},
          {"lifted", "one corner lifted", {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0.9}, {-1, 1, 0}}}},
          {"saddle", "a saddle", saddle(0.4)},
          {"steep", "a steeper saddle", saddle(0.9)},
          {"arrowhead", "an arrowhead", {{{-1, -1, 0}, {1, -1, 0}, {-0.4, -0.4, 0}, {-1, 1, 0}}}},
          {"bow-tie", "a bow-tie", {{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}}}};
}

class ValidQuadsFigure final : public PaperFigure {
 public:
  std::string name() const override { return "valid quads"; }
  int parts() const override { return 1; }

  FigureFindings part(int /*part*/, int /*jobs*/) const override {
    FigureFindings found;
    for (const NamedQuad& one : quads_) {
      const std::string key = key_of(one);
      found[key].name = key;
      found[key].vertices = bilinear_surface(one.quad, kSteps).vertices;
    }
    return found;
  }

  bool is_in(const FigureFindings& found) const override {
    return std::ranges::all_of(quads_, [&](const NamedQuad& one) {
      const auto at = found.find(key_of(one));
      return at != found.end() && at->second.vertices.size() == std::size_t{(kSteps + 1) * (kSteps + 1)};
    });
  }

  std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const override {
    reports::FigureSheet sheet{.name = "t18-valid-quads",
                               .heading = "Which quads are valid",
                               .source = "[T18] Figure 5, Definition 1",
                               .text = "",
                               .columns = static_cast<int>(quads_.size()),
                               .view = {{0.35, -1, 0.9}, {0, 0, 1}},
                               .panels = {}};
    std::size_t valid = 0;
    for (const NamedQuad& one : quads_) {
      const auto reason = invalid_because(one.quad);
      valid += reason ? 0 : 1;
      reports::FigurePanel panel = panel_of(one.file, one.title, one.quad, reason);
      panel.note = reason ? "not valid" : "valid";
      panel.data.vertices = found.at(key_of(one)).vertices;
      panel.data.faces = bilinear_surface(one.quad, kSteps).faces;
      sheet.panels.push_back(std::move(panel));
    }
    sheet.text = fmt::format(
        "Above: bilinear quads. Below: the least convex of each quad's projections along the normals of three "
        "successive corners. {} quads are valid, because all of their projections are convex, and {} are not. \"least "
        "sine\" is that of the projection's angles: 1 for right angles, negative where it is not convex. Red faces "
        "show their inner side: the planar quads fold over there.",
        valid, quads_.size() - valid);
    for (const NamedQuad& one : quads_) sheet.panels.push_back(projected(one, sheet.view));
    return {std::move(sheet)};
  }

 private:
  static std::string key_of(const NamedQuad& one) { return "figure/t18-valid-quads/" + one.file; }

  static reports::FigurePanel panel_of(const std::string& file, const std::string& title, const Quad<double>& border,
                                       const std::optional<std::string>& reason) {
    reports::FigurePanel panel;
    panel.title = title;
    panel.file = file;
    panel.data.name = file;
    panel.cage.assign(border.begin(), border.end());
    panel.cage_faces = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    panel.facts = {{"cage", "one quad"}, {"valid", reason ? "no" : "yes"}};
    if (reason) panel.facts.emplace_back("reason", *reason);
    return panel;
  }

  // The least convex projection, turned towards the viewer.
  static reports::FigurePanel projected(const NamedQuad& one, const reports::FigureView& view) {
    const LeastConvex least = least_convex_projection(one.quad);
    const Vec3<double> towards = view.towards.normalized(), right = view.up.cross(towards).normalized(),
                       up = towards.cross(right);
    Quad<double> turned;
    for (std::size_t k = 0; k < 4; ++k) turned[k] = least.projection[k][0] * right + least.projection[k][1] * up;
    const int c = least.corner;
    reports::FigurePanel panel =
        panel_of(one.file + ".projection", fmt::format("along the normal of {}, {}, {}", (c + 3) % 4, c, (c + 1) % 4),
                 turned, invalid_because(one.quad));
    panel.data.vertices.assign(turned.begin(), turned.end());
    panel.data.faces = {};
    panel.note = fmt::format("least sine {:.2f}", least.sine);
    panel.measured = {{"least sine of a projected angle", least.sine}};
    return panel;
  }

  static constexpr int kSteps = 16;
  std::vector<NamedQuad> quads_ = quads_to_judge();
};

struct NamedPoint {
  std::string file, title;
  Vec3<double> point;
};

// Algorithm 1 of the scheme at some points, by what it says of its steps.
class ProjectionFigure final : public PaperFigure {
 public:
  std::string name() const override { return "projection to a quad"; }
  int parts() const override { return 1; }

  FigureFindings part(int /*part*/, int /*jobs*/) const override {
    FigureFindings found;
    const StepFunction<double> steps = steps_of("quad.mean_value", "riemann-2").of<double>();
    for (const NamedPoint& one : points_) {
      const auto all = steps({.corners = std::span(quad_), .point = one.point});
      const auto values = [&](std::string_view name) -> const std::vector<double>& {
        const auto at = std::ranges::find(all, name, &Step<double>::name);
        if (at == all.end()) throw std::logic_error(fmt::format("the scheme has no step {}", name));
        return at->values;
      };
      const auto vector = [&](std::string_view name) {
        return Vec3<double>(values(name)[0], values(name)[1], values(name)[2]);
      };
      MeshField& field = found[key_of(one)];
      field.name = key_of(one);
      field.vertices = {one.point, vector("hull_point"), vector("projection")};
      // The parameters' lines, u = 0 ... 1 and v = 0 ... 1, in points of the plane.
      for (int k = 0; k < kSamples; ++k) field.vertices.emplace_back(values("grid_u")[k], values("grid_v")[k], 0);
    }
    return found;
  }

  bool is_in(const FigureFindings& found) const override {
    return std::ranges::all_of(points_, [&](const NamedPoint& one) {
      const auto at = found.find(key_of(one));
      return at != found.end() && at->second.vertices.size() == std::size_t{3 + kSamples};
    });
  }

  std::vector<reports::FigureSheet> sheets(const FigureFindings& found) const override {
    reports::FigureSheet sheet{
        .name = "t18-projection",
        .heading = "How a point is projected to a quad, and where the quad is sampled",
        .source = "[T18] Figures 8 and 9, Algorithm 1",
        .text =
            "Above: a point (the end of the red line) is projected to the hull of the quad's corners (blue), unless it "
            "lies within, and then to the quad. Below: the 5 x 5 samples around that projection, whose lines are "
            "straight, and which move smoothly with the point. Distances are over the length of the quad's box's "
            "diagonal.",
        .columns = static_cast<int>(points_.size()),
        .view = {{0.3, -1, 0.55}, {0, 0, 1}},
        .panels = {}};
    for (const bool samples : {false, true})
      for (const NamedPoint& one : points_) sheet.panels.push_back(drawn(one, samples, found.at(key_of(one)).vertices));
    return {std::move(sheet)};
  }

 private:
  static std::string key_of(const NamedPoint& one) { return "figure/t18-projection/" + one.file; }

  reports::FigurePanel drawn(const NamedPoint& one, bool samples, const std::vector<Vec3<double>>& found) const {
    reports::FigurePanel panel;
    panel.title = one.title;
    panel.file = one.file + (samples ? ".samples" : ".projection");
    panel.data = bilinear_surface(quad_, 12);
    panel.data.name = panel.file;
    panel.cage.assign(quad_.begin(), quad_.end());
    panel.facts = {{"cage", "one quad"}, {"evaluation", "riemann-2"}};
    const double size = (quad_[2] - quad_[0]).cwiseAbs().cwiseMax((quad_[3] - quad_[1]).cwiseAbs()).norm();
    const auto add_line = [&](const Vec3<double>& from, const Vec3<double>& to) {
      const int first = static_cast<int>(panel.data.vertices.size());
      panel.data.vertices.push_back(from);
      panel.data.vertices.push_back(to);
      panel.data.segments.push_back({first, first + 1});
    };
    if (samples) {
      panel.cage_faces = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
      for (int k = 0; k < kSamples; ++k) {
        const double u = found[3 + k][0], v = found[3 + k][1];
        add_line(bilinear_point(quad_, u, 0), bilinear_point(quad_, u, 1));
        add_line(bilinear_point(quad_, 0, v), bilinear_point(quad_, 1, v));
        for (int l = 0; l < kSamples; ++l) panel.marks.push_back(bilinear_point(quad_, u, found[3 + l][1]));
      }
      const double u = found[3 + kSamples / 2][0], v = found[3 + kSamples / 2][1];
      panel.note = fmt::format("u = {:.2f}, v = {:.2f}", u, v);
      panel.measured = {{"u", u}, {"v", v}};
      return panel;
    }
    panel.cage_faces = {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 3, 2}};
    panel.marks = {found[0], found[1], found[2]};
    add_line(found[0], found[1]);
    add_line(found[1], found[2]);
    const double to_hull = (found[1] - found[0]).norm() / size, to_quad = (found[2] - found[1]).norm() / size;
    panel.note = fmt::format("to the hull {:.3f}, to the quad {:.3f}", to_hull, to_quad);
    panel.measured = {{"distance to the hull over size", to_hull}, {"distance to the quad over size", to_quad}};
    return panel;
  }

  static constexpr int kSamples = 5;
  Quad<double> quad_ = saddle(0.4);
  std::vector<NamedPoint> points_{{"above", "outside, above", {0.35, -0.2, 1.3}},
                                  {"beside", "outside, beside", {1.7, -0.8, 0.5}},
                                  {"within", "within the hull", {-0.15, 0.2, 0.24}},
                                  {"near", "within, next to the quad", {0.55, 0.5, 0.15}}};
};

}  // namespace

std::unique_ptr<const PaperFigure> valid_quads_figure() { return std::make_unique<ValidQuadsFigure>(); }
std::unique_ptr<const PaperFigure> projection_figure() { return std::make_unique<ProjectionFigure>(); }

}  // namespace cageproof::validation
