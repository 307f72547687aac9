// SPDX-License-Identifier: MIT
// Figures of bars, in space and in the plane.
#include "embedded_figures.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <fmt/format.h>

#include <numbers>

namespace cageproof::validation {
std::string comparison_text() {
  return "One posed cage (blue), and what each deformer makes of the mesh in it. Mean value coordinates meet the cage "
         "and "
         "may dent the mesh; Green coordinates keep angles and leave the cage; the regularised biharmonic ones follow "
         "it "
         "more closely, with unit normal derivatives or with those of least energy (AHAP, AAAP, TP); Somigliana "
         "coordinates behave as an elastic body. Red: faces that show their inner side.";
}

std::string elastic_text(const std::string& variant) {
  return fmt::format(
      "Somigliana coordinates, {} variant: Poisson's ratio ν by columns, bulging γ by rows; in the first column the "
      "mesh "
      "at rest and what mean value and Green coordinates make of it. Where γ is positive, faces of the cage whose "
      "spread "
      "of normals grows push outwards and those whose spread shrinks pull inwards, where it is negative the other way "
      "round, and the more strongly the nearer ν is to 1/2.{}",
      variant,
      variant == "local" ? " There local stretches that differ drive the mesh out of its cage, and turn it inside out."
                         : "");
}

std::vector<PanelPlan> comparison_panels(const std::vector<Vec3<double>>& posed) {
  std::vector<PanelPlan> panels{
      {.title = "at rest", .file = "rest"},
      {.title = "mean value", .file = "mean_value", .method = "mean_value"},
      {.title = "Green", .file = "green", .method = "green"},
      {.title = "biharmonic (1,3)", .file = "biharmonic_1_3", .method = "biharmonic_1_3"},
      {.title = "biharmonic (1,2)", .file = "biharmonic_1_2", .method = "biharmonic_1_2"},
      {.title = "AHAP", .file = "ahap", .method = "ahap", .parameters = {{"alignment", "nonnegative"}}},
      {.title = "AAAP", .file = "aaap", .method = "aaap"},
      {.title = "TP", .file = "tp", .method = "tp"}};
  for (const std::string variant : {"global", "local"})
    panels.push_back({.title = fmt::format("Somigliana, {}", variant),
                      .file = fmt::format("somigliana.{}", variant),
                      .method = "somigliana",
                      .parameters = {{"variant", variant}, {"nu", "0.3"}, {"gamma", "1"}}});
  for (PanelPlan& panel : panels)
    if (!panel.method.empty()) panel.posed = posed;
  return panels;
}

std::vector<PanelPlan> elastic_panels(const std::vector<Vec3<double>>& posed, const std::string& variant) {
  const std::vector<PanelPlan> beside{
      {.title = "at rest", .file = "rest"},
      {.title = "mean value", .file = "mean_value", .method = "mean_value", .posed = posed},
      {.title = "Green", .file = "green", .method = "green", .posed = posed}};
  std::vector<PanelPlan> panels;
  std::size_t row = 0;
  for (const std::string gamma : {"-2", "0", "4"}) {
    panels.push_back(beside[row++]);
    for (const std::string nu : {"0", "0.3", "0.45"})
      panels.push_back({.title = fmt::format("ν = {}, γ = {}", nu, gamma),
                        .file = fmt::format("nu{}.gamma{}", nu, gamma),
                        .method = "somigliana",
                        .parameters = {{"variant", variant}, {"nu", nu}, {"gamma", gamma}},
                        .posed = posed});
  }
  return panels;
}

std::unique_ptr<const PaperFigure> bar_figure() {
  const auto bent = bent_bar(100 * std::numbers::pi / 180, 1);
  DeformedPlan plan{.name = "bar",
                    .cage = std::make_shared<const Cage>(bar_cage()),
                    .mesh = rounded_box({0.4, 0.4, 0.9}, 0.12, 0.1),
                    .sheets = {}};
  plan.sheets = {{.name = "t24-bend",
                  .heading = "Deformers compared: a bent bar",
                  .source = "[T24] Figures 1, 2, 3 and 5, [C23] Figure 11",
                  .text = comparison_text(),
                  .columns = 5,
                  .panels = comparison_panels(bent),
                  .view = bar_view},
                 {.name = "t24-twist",
                  .heading = "Deformers compared: a twisted bar",
                  .source = "[T24] Figures 1, 2, 3 and 5, [C23] Figure 11",
                  .text = comparison_text(),
                  .columns = 5,
                  .panels = comparison_panels(twisted_bar_pose()),
                  .view = bar_view}};
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> pressed_figure() {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  // Flatter, wider, and narrower above than below.
  std::vector<Vec3<double>> pressed = cage->vertices();
  for (Vec3<double>& p : pressed) {
    const double wide = p[2] > 0 ? 1.15 : 1.4;
    p = Vec3<double>(wide * p[0], wide * p[1], 0.5 * p[2]);
  }
  DeformedPlan plan{
      .name = "pressed", .cage = cage, .mesh = rounded_box({0.44, 0.44, 0.44}, 0.14, 0.055), .sheets = {}};
  for (const std::string variant : {"global", "local"})
    plan.sheets.push_back({.name = "c23-" + variant,
                           .heading = fmt::format("Poisson's ratio and bulging: {} variant", variant),
                           .source = "[C23] Figures 1, 2 and 5",
                           .text = elastic_text(variant),
                           .columns = 4,
                           .panels = elastic_panels(pressed, variant),
                           .view = {{0.45, -1, 0.45}, {0, 0, 1}}});
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> plane_bar_figure() {
  const double angle = std::numbers::pi;
  const auto cage = std::make_shared<const Cage>(plane_bar());
  std::vector<Vec3<double>> posed;
  for (const Vec3<double>& v : cage->vertices()) posed.push_back(bent_in_plane(v, angle));
  deformation::Constraints held;
  for (const double x : {0.5, 3.0, 5.5}) held.positions.push_back({{x, 1, 0}, bent_in_plane({x, 1, 0}, angle)});
  const auto boundary = [](const std::string& title, const std::string& normals) {
    return PanelPlan{.title = title,
                     .file = "biharmonic_boundary." + normals,
                     .method = "biharmonic_boundary",
                     .parameters = {{"normals", normals}}};
  };
  std::vector<PanelPlan> panels{
      {.title = "at rest", .file = "rest", .constraints = held},
      {.title = "mean value", .file = "mean_value", .method = "mean_value"},
      {.title = "harmonic", .file = "harmonic", .method = "harmonic"},
      {.title = "Green (Cauchy)", .file = "green", .method = "green"},
      boundary("biharmonic, unit normals", "unit"),
      boundary("biharmonic, complex", "complex"),
      boundary("biharmonic, AHAP", "ahap"),
      {.title = "thickness, three points held", .file = "thickness", .method = "thickness", .constraints = held}};
  for (PanelPlan& panel : panels)
    if (!panel.method.empty() && panel.constraints.positions.empty()) panel.posed = posed;
  return deformed_figure(
      {.name = "plane bar",
       .cage = cage,
       .mesh = grid(6, 2, 0.125),
       .sheets = {
           {.name = "w12-bar",
            .heading = "A bar of the plane, bent",
            .source = "[W12] Figures 1 and 5",
            .text =
                "The polygon (blue) bent to half a circle; the grid has squares at rest, and its middle line is red. "
                "Mean value "
                "coordinates meet the polygon, harmonic ones nearly (by boundary elements), and both shear the squares "
                "beside it; Green coordinates keep angles and miss the polygon; biharmonic ones nearly meet it, with "
                "normal derivatives that are posed unit normals, those that a complex map has, or those that make "
                "Laplacians on the boundary least. Last, no polygon is given: three points are held (dots), and the "
                "polygon found bends least across its edges, so that the bar stays as thick as it was.",
            .columns = 4,
            .panels = std::move(panels)}}});
}

}  // namespace cageproof::validation
