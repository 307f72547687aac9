// SPDX-License-Identifier: MIT
// [W12]'s figures of posed polygons.
#include "embedded_figures.h"
#include "plane_shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cageproof::validation {
namespace {

PanelPlan boundary(const std::string& title, const std::string& normals) {
  return {.title = title,
          .file = "biharmonic_boundary." + normals,
          .method = "biharmonic_boundary",
          .parameters = {{"normals", normals}, {"pieces", "8"}}};
}

std::vector<PanelPlan> posed_by(const std::vector<Vec3<double>>& posed, std::vector<PanelPlan> panels) {
  for (PanelPlan& panel : panels)
    if (!panel.method.empty()) panel.posed = posed;
  return panels;
}

// The unit square mapped to itself with normal derivatives `length` times the outward normals, turned by `turn` on
// every edge, or one way and the other.
PanelPlan same_square(const Cage& square, const std::string& title, const std::string& file, double length, double turn,
                      bool alternates = false) {
  PanelPlan panel{.title = title,
                  .file = file,
                  .method = "biharmonic_boundary",
                  .parameters = {{"pieces", "8"}},
                  .posed = square.vertices()};
  for (int edge = 0; edge < 4; ++edge) {
    const double angle =
        (edge - 1) * std::numbers::pi / 2 + (alternates && edge % 2 == 1 ? -turn : turn) * std::numbers::pi / 180;
    panel.normal_derivatives.emplace_back(length * std::cos(angle), length * std::sin(angle), 0);
  }
  return panel;
}

}  // namespace

std::unique_ptr<const PaperFigure> trousers_figure() {
  const auto cage = std::make_shared<const Cage>(plane_trousers());
  DeformedPlan plan{.name = "trousers", .cage = cage, .mesh = trousers_mesh(*cage), .sheets = {}};
  plan.watched = "the still leg";
  const auto& vertices = plan.mesh.mesh.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v][0] < 2 && vertices[v][1] < 1.5) plan.watched_vertices.push_back(static_cast<int>(v));
  plan.sheets = {
      {.name = "w12-legs",
       .heading = "Legs that repel each other",
       .source = "[W12] Figure 2, without Hermite mean value coordinates",
       .text = "Trousers (blue) with one leg lifted, and the other left where it is. Mean value coordinates are "
               "negative across the gap, and push the still leg away; harmonic ones are positive and leave it "
               "there, but shear the squares beside the cage; Green coordinates (Cauchy's) keep angles and miss "
               "the cage; biharmonic ones follow it with normal derivatives that are unit normals.",
       .columns = 3,
       .panels = posed_by(lifted_leg(*cage), {{.title = "at rest", .file = "rest"},
                                              {.title = "mean value", .file = "mean_value", .method = "mean_value"},
                                              {.title = "harmonic", .file = "harmonic", .method = "harmonic"},
                                              {.title = "Green (Cauchy)", .file = "green", .method = "green"},
                                              boundary("biharmonic, unit normals", "unit")})}};
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> square_figure() {
  const auto cage = std::make_shared<const Cage>(plane_square());
  const std::vector<Vec3<double>> rhombus{{0.5, 0.32, 0}, {1.2, 0.5, 0}, {0.5, 0.68, 0}, {-0.2, 0.5, 0}};
  DeformedPlan plan{.name = "square", .cage = cage, .mesh = square_mesh(*cage, 16), .sheets = {}};
  plan.sheets = {
      {.name = "w12-same-square",
       .heading = "A square mapped to itself by its normal derivatives",
       .source = "[W12] Figure 4",
       .text = "Biharmonic maps that all keep the border of the square (blue) and differ only in the derivatives along "
               "its outward normals, one vector per edge: n is the unit normal, an angle turns it. Six times the "
               "normal is too large: the map overlaps itself.",
       .columns = 4,
       .panels = {{.title = "at rest", .file = "rest"},
                  same_square(*cage, "n", "identity", 1, 0),
                  same_square(*cage, "2 n", "double", 2, 0),
                  same_square(*cage, "0", "zero", 0, 0),
                  same_square(*cage, "n, turned by 60°", "turned", 1, 60),
                  same_square(*cage, "n, turned by ± 60°", "alternating", 1, 60, true),
                  same_square(*cage, "2 n, turned by 60°", "double.turned", 2, 60),
                  same_square(*cage, "6 n", "sixfold", 6, 0)}},
      {.name = "w12-rhombus",
       .heading = "A square made a rhombus",
       .source = "[W12] Figure 8",
       .text = "The rhombus (blue) is the square under an affine map, which harmonic coordinates give, with sheared "
               "squares at the border. Biharmonic coordinates make lines meet the border at right angles: unit normals "
               "are too long for so thin a rhombus, and the map overlaps itself in the middle; normals of least "
               "Laplacians on the border (AHAP) leave it one to one.",
       .columns = 4,
       .panels = posed_by(rhombus, {{.title = "at rest", .file = "rest"},
                                    {.title = "harmonic", .file = "harmonic", .method = "harmonic"},
                                    boundary("biharmonic, unit normals", "unit"),
                                    boundary("biharmonic, AHAP", "ahap")})}};
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> star_figure() {
  const auto cage = std::make_shared<const Cage>(plane_star());
  const std::vector<Vec3<double>> posed = swirled_star(*cage);
  DeformedPlan plan{.name = "star", .cage = cage, .mesh = star_mesh(*cage), .sheets = {}};
  plan.angles = {{"next to the border", beside_edges(*cage, 1e-3, 8)}, {"further in", beside_edges(*cage, 0.06, 8)}};
  plan.sheets = {
      {.name = "w12-star",
       .heading = "A star by Cauchy's coordinates and by complex biharmonic ones",
       .source = "[W12] Figure 6",
       .text = "Cauchy's coordinates keep angles everywhere and miss the posed star (blue); complex biharmonic ones "
               "follow it, and keep angles roughly next to the border; harmonic ones follow it and keep them nowhere. "
               "Captions state by how much the angle between two directions changes at most, as a mean over points at "
               "0.001 and 0.06 of the star's size from its edges.",
       .columns = 4,
       .panels = posed_by(
           posed, {{.title = "at rest", .file = "rest"},
                   {.title = "Cauchy (Green)", .file = "cauchy", .method = "cauchy"},
                   boundary("complex biharmonic", "complex"),
                   {.title = "harmonic", .file = "harmonic", .method = "harmonic", .parameters = {{"pieces", "8"}}}})}};
  return deformed_figure(std::move(plan));
}

}  // namespace cageproof::validation
