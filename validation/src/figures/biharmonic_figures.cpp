// SPDX-License-Identifier: MIT
// [T24]'s figures of the choices that its coordinates leave: weights, alignment, subspaces, and integrals by rules.
#include "embedded_figures.h"
#include "space_shapes.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <fmt/format.h>

#include <numbers>

namespace cageproof::validation {
namespace {

// Vertices under an affine map that turns normals of some faces: a shear.
std::vector<Vec3<double>> sheared(std::vector<Vec3<double>> vertices) {
  for (Vec3<double>& p : vertices) p[0] += 0.5 * p[2];
  return vertices;
}

SheetPlan gamma_sheet(const std::vector<Vec3<double>>& bent, const std::vector<Vec3<double>>& twisted) {
  SheetPlan sheet{.name = "t24-gamma",
                  .heading = "Fitting positions more or less closely",
                  .source = "[T24] Figures 3 and 4",
                  .text =
                      "Biharmonic coordinates (1,3), whose weight γ_D of positions against Laplacians grows from "
                      "left to right: the mesh follows the cage more closely, and may show waves. To their right "
                      "the other two constructions: (1,2), and the one after Weber et al., which fits Laplacians "
                      "first and then positions. \"off by\": the largest distance from the image by mean value "
                      "coordinates, which meet the cage, over the cage's size; \"turns by\": by how much the map "
                      "sharpens an edge between two faces "
                      "at most.",
                  .columns = 6,
                  .panels = {},
                  .view = bar_view};
  for (const bool is_bent : {true, false}) {
    const std::string suffix = is_bent ? ".bent" : ".twisted";
    const auto& posed = is_bent ? bent : twisted;
    sheet.panels.push_back(
        {.title = "mean value", .file = "mean_value" + suffix, .method = "mean_value", .posed = posed});
    for (const std::string gamma : {"0.01", "1", "100"})
      sheet.panels.push_back({.title = "(1,3), γ_D = " + gamma,
                              .file = fmt::format("gamma{}{}", gamma, suffix),
                              .method = "biharmonic_1_3",
                              .parameters = {{"gamma_d", gamma}},
                              .posed = posed,
                              .compared_with = "mean_value" + suffix});
    for (const auto& [title, method] :
         {std::pair{"(1,2)", "biharmonic_1_2"}, {"after Weber et al.", "biharmonic_weber"}})
      sheet.panels.push_back({.title = title,
                              .file = method + suffix,
                              .method = method,
                              .posed = posed,
                              .compared_with = "mean_value" + suffix});
  }
  return sheet;
}

SheetPlan alignment_sheet(const std::vector<Vec3<double>>& rest, const std::vector<Vec3<double>>& bent) {
  SheetPlan sheet{
      .name = "t24-alignment",
      .heading = "Normal derivatives, aligned and free",
      .source = "[T24] Figure 5",
      .text =
          "Biharmonic coordinates (1,3) with unit normal derivatives, and with those of least energy, "
          "aligned with posed normals (γ_a = ∞), drawn to them (γ_a = 1) or free (γ_a = 0). Above, the cage is "
          "sheared: "
          "AAAP and TP that are free make the affine map, as mean value coordinates do; those that are aligned "
          "cannot, because a shear does not move normals as it moves edges. Below, the cage is bent. \"off by\": the "
          "largest distance from the image by mean value coordinates, over the cage's size.",
      .columns = 8,
      .panels = {},
      .view = bar_view};
  for (const bool is_sheared : {true, false}) {
    const std::string suffix = is_sheared ? ".sheared" : ".bent";
    const auto posed = is_sheared ? sheared(rest) : bent;
    const auto add = [&](const std::string& title, const std::string& file, const std::string& method,
                         const std::vector<std::pair<std::string, std::string>>& parameters) {
      sheet.panels.push_back({.title = title,
                              .file = file + suffix,
                              .method = method,
                              .parameters = parameters,
                              .posed = posed,
                              .compared_with = method == "mean_value" ? "" : "mean_value" + suffix});
    };
    add("mean value", "mean_value", "mean_value", {});
    add("unit", "unit", "biharmonic_1_3", {});
    for (const auto& [title, method] : {std::pair{"AAAP", "aaap"}, {"TP", "tp"}}) {
      add(fmt::format("{}, γ_a = ∞", title), fmt::format("{}.hard", method), method, {{"alignment", "hard"}});
      add(fmt::format("{}, γ_a = 1", title), fmt::format("{}.soft", method), method,
          {{"alignment", "soft"}, {"gamma_a", "1"}});
      add(fmt::format("{}, γ_a = 0", title), fmt::format("{}.free", method), method, {{"alignment", "free"}});
    }
  }
  return sheet;
}

// Its upper end is turned and moved, its lower end is held; rotations along its middle, Hessians next to its sides.
deformation::Constraints turned_end(double angle) {
  deformation::Constraints held;
  for (const double z : {-0.9, 0.9})
    for (const auto& [x, y] : {std::pair{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}) {
      const Vec3<double> at(x, y, z);
      held.positions.push_back({at, z < 0 ? at : bent_about_y({at}, 2 * angle).front()});
    }
  // The lower end of an arc bent about the middle is turned, too: the arc is turned back.
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec3<double> foot = bent_about_y({{0, 0, -0.9}}, 2 * angle).front();
  for (auto& position : held.positions) {
    if (position.at[2] < 0) continue;
    const Vec3<double> p = position.to - foot;
    position.to = Vec3<double>(c * p[0] + s * p[2], p[1], -s * p[0] + c * p[2]) + Vec3<double>(0, 0, -0.9);
  }
  for (int k = -4; k <= 4; ++k) held.rotations.emplace_back(0, 0, 0.2 * k);
  for (int k = -4; k <= 4; ++k)
    for (const double side : {-0.2, 0.2})
      for (const auto& [x, y] : {std::pair{-0.45, side}, {0.45, side}, {side, 0.45}, {side, -0.45}})
        held.hessians.emplace_back(x, y, 0.22 * k);
  return held;
}

}  // namespace

std::unique_ptr<const PaperFigure> biharmonic_choices_figure() {
  const auto cage = std::make_shared<const Cage>(bar_cage());
  const auto bent = bent_bar(100 * std::numbers::pi / 180, 1);
  return deformed_figure({.name = "biharmonic choices",
                          .cage = cage,
                          .mesh = rounded_box({0.46, 0.46, 0.94}, 0.1, 0.12),
                          .sheets = {gamma_sheet(bent, twisted_about_z(cage->vertices(), 0.8 * std::numbers::pi)),
                                     alignment_sheet(cage->vertices(), bent)},
                          .measures_turns = true});
}

std::unique_ptr<const PaperFigure> variational_figure() {
  SheetPlan sheet{.name = "t24-variational",
                  .heading = "Maps of least energy, harmonic and biharmonic",
                  .source = "[T24] Figure 6",
                  .text =
                      "No posed cage: points of both ends are held (dots), the upper ones turned by 80 degrees, "
                      "rotations are asked along the middle, and small second derivatives next to the sides. The "
                      "map of least energy is sought among the biharmonic or the harmonic maps that the cage (at "
                      "rest, blue) has. The biharmonic maps of a box in two pieces suffice to bend the mesh "
                      "smoothly; harmonic ones have a vertex's freedom per vertex of the cage. \"turns by\": by "
                      "how much the map sharpens an edge between two faces at most.",
                  .columns = 4,
                  .panels = {},
                  .view = {{0.3, -1, 0.3}, {0, 0, 1}}};
  const auto held = turned_end(40 * std::numbers::pi / 180);
  for (const auto& [subspace, pieces] :
       {std::pair{"biharmonic", 2}, {"harmonic", 2}, {"harmonic", 3}, {"harmonic", 6}}) {
    const auto cage = std::make_shared<const Cage>(plain_bar(pieces));
    sheet.panels.push_back({.title = fmt::format("{}, V = {}", subspace, cage->vertices().size()),
                            .file = fmt::format("{}.{}", subspace, cage->vertices().size()),
                            .method = "variational",
                            .parameters = {{"subspace", subspace}, {"beta", "0.1"}, {"gamma", "1e-5"}},
                            .constraints = held,
                            .shows_diagonals = true,
                            .cage = cage});
  }
  return deformed_figure({.name = "variational",
                          .cage = std::make_shared<const Cage>(plain_bar(2)),
                          .mesh = rounded_box({0.46, 0.46, 0.94}, 0.1, 0.08),
                          .sheets = {std::move(sheet)},
                          .measures_turns = true});
}

std::unique_ptr<const PaperFigure> spikes_figure() {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  std::vector<Vec3<double>> posed = cage->vertices();
  for (Vec3<double>& p : posed)
    p = p[2] > 0 ? Vec3<double>(0.7 * p[0] + 0.2, 0.7 * p[1], p[2] + 0.2) : Vec3<double>(1.2 * p[0], p[1], p[2]);
  const auto by = [&](const std::string& title, const std::string& evaluation) {
    return PanelPlan{.title = title,
                     .file = evaluation.empty() ? "closed_form" : evaluation,
                     .method = "somigliana",
                     .posed = posed,
                     .evaluation = evaluation,
                     .compared_with = evaluation.empty() ? "" : "closed_form"};
  };
  return deformed_figure(
      {.name = "spikes",
       .cage = cage,
       .mesh = rounded_box({0.465, 0.465, 0.465}, 0.06, 0.05),
       .sheets =
           {{.name = "t24-spikes",
             .heading = "Spikes by quadrature next to the cage",
             .source = "[T24] Figure 8",
             .text =
                 "Somigliana coordinates of a mesh close to its cage, by closed forms, and by quadrature with 75 "
                 "and 300 points per triangle: vertices of the mesh next to a point of the rule are thrown out. \"off "
                 "by\": the largest distance from the image by closed forms, over the cage's size.",
             .columns = 4,
             .panels = {{.title = "at rest", .file = "rest"},
                        by("closed forms", ""),
                        by("75 points per triangle", "three-quad-75"),
                        by("300 points per triangle", "three-quad-300")},
             .view = {{0.45, -1, 0.45}, {0, 0, 1}}}},
       .measures_turns = true});
}

}  // namespace cageproof::validation
