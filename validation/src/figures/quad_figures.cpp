// SPDX-License-Identifier: MIT
// [T18]'s figures of deformed meshes: how quads are integrated, and what other coordinates do to cages of quads.
#include "embedded_figures.h"
#include "space_shapes.h"

#include <fmt/format.h>

#include <numbers>

namespace cageproof::validation {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

// A panel of a kind of coordinates; of an evaluation of its formulas, it is compared with the panel `exact`.
PanelPlan quad_panel(const std::string& title, const std::string& method, const std::vector<Vec3<double>>& posed,
                     const std::string& evaluation = "") {
  return {.title = title,
          .file = evaluation.empty() ? method : evaluation,
          .method = method,
          .posed = posed,
          .evaluation = evaluation,
          .compared_with = evaluation.empty() ? "" : "quad_mean_value"};
}

const PanelPlan at_rest{.title = "at rest", .file = "rest"};

}  // namespace

std::unique_ptr<const PaperFigure> tessellation_figure() {
  const auto cage = std::make_shared<const Cage>(plain_bar(1));
  const auto posed = twisted_about_z(cage->vertices(), quarter_turn);
  const auto by = [&](const std::string& title, const std::string& evaluation) {
    return quad_panel(title, "quad_mean_value", posed, evaluation);
  };
  return deformed_figure(
      {.name = "tessellation",
       .cage = cage,
       .mesh = rounded_box({0.485, 0.485, 0.97}, 0.06, 0.1),
       .sheets = {{.name = "t18-tessellation",
                   .heading = "Quads in triangles, and exact",
                   .source = "[T18] Figure 4",
                   .text =
                       "A box of six quads, twisted by 90 degrees, and a mesh close to it, by mean value coordinates "
                       "whose quads are cut in n x n x 2 triangles. The triangles' edges show as creases of the "
                       "mesh, which fade as n grows; the paper's scheme and exact integrals have none. \"off by\": "
                       "the largest distance from the exact image, over the cage's size; \"turns by\": by how "
                       "much the map sharpens an edge between two faces at most.",
                   .columns = 6,
                   .panels = {at_rest, by("n = 1", "tessellated-1"), by("n = 2", "tessellated-2"),
                              by("n = 6", "tessellated-6"), by("scheme, 9 x 9 samples", "riemann-4"),
                              by("exact (line form)", "")},
                   .view = bar_view}},
       .measures_turns = true});
}

std::unique_ptr<const PaperFigure> norm_correction_figure() {
  const auto cage = std::make_shared<const Cage>(plain_bar(1));
  const auto posed = twisted_about_z(cage->vertices(), quarter_turn);
  const auto by = [&](const std::string& title, const std::string& evaluation) {
    return quad_panel(title, "quad_mean_value", posed, evaluation);
  };
  return deformed_figure(
      {.name = "norm correction",
       .cage = cage,
       .mesh = rounded_box({0.38, 0.38, 0.86}, 0.1, 0.09),
       .sheets = {{.name = "t18-norm-correction",
                   .heading = "The norm correction on coarse grids",
                   .source = "[T18] Figure 7",
                   .text =
                       "A box of six quads, twisted by 90 degrees, by the paper's scheme with (2n + 1) x (2n + 1) "
                       "samples per quad, with its norm correction (Eq 24) and without it. Corrected, 3 x 3 samples "
                       "are close to the exact image; without it, they are far from it, and 9 x 9 are not close. "
                       "\"off by\": the largest distance from the exact image, over the cage's size.",
                   .columns = 6,
                   .panels = {at_rest, by("exact", ""), by("3 x 3, corrected", "riemann-1"),
                              by("3 x 3, uncorrected", "riemann-1-uncorrected"),
                              by("9 x 9, uncorrected", "riemann-4-uncorrected"),
                              by("121 x 121, uncorrected", "riemann-60-uncorrected")},
                   .view = bar_view}}});
}

std::unique_ptr<const PaperFigure> twisted_box_figure() {
  const auto straight = plain_bar(1).vertices();
  const double angle = 70 * std::numbers::pi / 180;
  const auto cage =
      std::make_shared<const Cage>(Cage::make("twisted box", twisted_about_z(straight, angle), plain_bar(1).faces()));
  // Turned back, and beyond.
  const auto posed = twisted_about_z(straight, -0.5 * angle);
  PanelPlan triangulated = quad_panel("mean value, triangulated", "mean_value", posed);
  triangulated.shows_diagonals = true;
  return deformed_figure(
      {.name = "twisted box",
       .cage = cage,
       .mesh = rounded_box({0.36, 0.36, 0.9}, 0.1, 0.06),
       .sheets = {{.name = "t18-twisted-box",
                   .heading = "A cage of strongly bent quads",
                   .source = "[T18] Figure 10",
                   .text = "A box twisted by 70 degrees at rest, whose quads cut through the mesh, twisted back by 105 "
                           "degrees. Mean value coordinates of triangles show their diagonals; those of quads are "
                           "smooth, exact (line form) as by the paper's scheme. \"turns by\": by how much the map "
                           "sharpens an edge between two faces at most.",
                   .columns = 4,
                   .panels = {at_rest, std::move(triangulated),
                              quad_panel("mean value, quads", "quad_mean_value", posed),
                              quad_panel("scheme, 9 x 9 samples", "quad_mean_value", posed, "riemann-4")},
                   .view = bar_view}},
       .measures_turns = true});
}

std::unique_ptr<const PaperFigure> spherical_figure() {
  const auto cage = std::make_shared<const Cage>(tower_cage());
  std::vector<Vec3<double>> posed = cage->vertices();
  for (Vec3<double>& p : posed)
    if (p[2] > 0) p += Vec3<double>(0, 0, 1.6);
  return deformed_figure(
      {.name = "spherical",
       .cage = cage,
       .mesh = tower_sheet(1.84 / 64),
       .sheets = {{.name = "t18-spherical",
                   .heading = "Spherical mean value coordinates of bent quads",
                   .source = "[T18] Figure 15",
                   .text =
                       "A tower of bent quads on a base, its top raised, and a flat sheet in the base. Spherical mean "
                       "value coordinates divide by the mean vector of a quad, which vanishes on its extended "
                       "diagonals: where those of the tower's quads cross the sheet, it has spikes. Mean value "
                       "coordinates of quads have none. \"turns by\": by how much the map sharpens an edge between two "
                       "faces at "
                       "most.",
                   .columns = 3,
                   .panels = {at_rest, quad_panel("mean value, quads", "quad_mean_value", posed),
                              quad_panel("spherical mean value", "spherical_mean_value", posed)},
                   .view = {{0.3, -0.7, 1}, {0, 0, 1}}}},
       .measures_turns = true});
}

std::unique_ptr<const PaperFigure> triquad_figure() {
  const auto cage = std::make_shared<const Cage>(pencil_cage());
  const auto bent = bent_about_y(cage->vertices(), 1.2),
             twisted = twisted_about_z(cage->vertices(), 1.3 * quarter_turn);
  DeformedPlan plan{
      .name = "triangles and quads", .cage = cage, .mesh = pencil_mesh(40), .sheets = {}, .measures_turns = true};
  SheetPlan sheet{.name = "t18-triquad",
                  .heading = "A cage of triangles and quads",
                  .source = "[T18] Figures 13 and 14",
                  .text =
                      "A tube of quads with a tip and an end of triangles, bent, and twisted. Mean "
                      "value coordinates of the triangulated cage show its diagonals; with quads kept, the map is "
                      "smooth across quads and passes from quads to triangles without artefacts. \"turns by\": by "
                      "how much the map sharpens an edge between two faces at most.",
                  .columns = 5,
                  .panels = {at_rest},
                  .view = {{0.3, -1, 0.3}, {0, 0, 1}}};
  for (const bool is_bent : {true, false}) {
    const std::string how = is_bent ? "bent" : "twisted";
    for (const std::string method : {"mean_value", "quad_mean_value"}) {
      PanelPlan panel = quad_panel(fmt::format("{}, {}", how, method == "mean_value" ? "triangulated" : "quads kept"),
                                   method, is_bent ? bent : twisted);
      panel.file += "." + how;
      panel.shows_diagonals = method == "mean_value";
      sheet.panels.push_back(std::move(panel));
    }
  }
  plan.sheets.push_back(std::move(sheet));
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> fork_figure() {
  const auto cage = std::make_shared<const Cage>(fork_cage());
  const Vec3<double> step(1.2, 0, 0);
  std::vector<Vec3<double>> posed = cage->vertices();
  for (Vec3<double>& p : posed)
    if (p[0] > 0 && p[2] == 2) p += step;
  DeformedPlan plan{.name = "fork", .cage = cage, .mesh = fork_mesh(0.08), .sheets = {}};
  SheetPlan sheet{
      .name = "t18-positive",
      .heading = "Limbs that are close to each other",
      .source = "[T18] Figures 16 and 17",
      .text =
          "A fork of quads, the end of its right prong moved to the right. Mean value coordinates of the "
          "four vertices moved are negative in the other prong, which is pushed to the left; dark: faces "
          "where their sum is below -0.01. Harmonic coordinates (by boundary elements, on a "
          "triangulation), and mean value coordinates made positive by maximum entropy, have no such "
          "places. \"least coordinate\": of that sum in the mesh.",
      .columns = 4,
      .panels = {at_rest, quad_panel("mean value, quads", "quad_mean_value", posed),
                 quad_panel("harmonic", "harmonic", posed), quad_panel("maximum entropy", "maximum_entropy", posed)},
      .view = {{0.25, -1, 0.3}, {0, 0, 1}}};
  for (PanelPlan& panel : sheet.panels)
    if (!panel.method.empty()) panel.step = step;
  sheet.panels[2].parameters = {{"level", "0"}};
  plan.sheets.push_back(std::move(sheet));
  return deformed_figure(std::move(plan));
}

}  // namespace cageproof::validation
