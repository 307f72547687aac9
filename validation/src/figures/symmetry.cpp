// SPDX-License-Identifier: MIT
// Figures of quad cages and of their triangulations, whose diagonals break symmetries.
#include "embedded_figures.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// The cube with its upper face drawn in and raised, or with it spread to both sides.
std::vector<Vec3<double>> symmetric_pose(const Cage& cage, bool tapered) {
  std::vector<Vec3<double>> posed = cage.vertices();
  for (Vec3<double>& p : posed) {
    if (tapered) p = p[2] > 0 ? Vec3<double>(0.3 * p[0], 0.3 * p[1], p[2] + 0.3) : p;
    else p = p[2] > 0 ? Vec3<double>(1.8 * p[0], 0.6 * p[1], p[2] - 0.1) : Vec3<double>(0.7 * p[0], p[1], p[2]);
  }
  return posed;
}

// The cube whose quads begin at their second corner, so that ties between diagonals fall the other way.
std::shared_ptr<const Cage> other_diagonals(const Cage& cage) {
  std::vector<Face> faces = cage.faces();
  for (Face& face : faces) std::ranges::rotate(face.vertices, face.vertices.begin() + 1);
  return std::make_shared<const Cage>(Cage::make(cage.name() + ", other diagonals", cage.vertices(), faces, {}));
}

// Shows how the choice of diagonals changes deformers with normals; kinds that keep quads need no choice.
SheetPlan diagonals_sheet(const Cage& cage) {
  SheetPlan sheet{
      .name = "quads-kept",
      .heading = "Deformers of quads, and of either triangulation",
      .source = "[T24], [C23], and Thiery, Boubekeur 2022, on bilinear faces",
      .text =
          "A cube in a pose that is symmetric between left and right, by deformers with posed normals: triangulated by "
          "the "
          "diagonals from its quads' first corners, by the others, and with its quads kept, which have four normals "
          "each. The asymmetry is the largest distance between the image of a point's mirror image and the mirror "
          "image "
          "of its image, over the cage's size.",
      .columns = 3,
      .panels = {},
      .view = {{0, -1, 0.55}, {0, 0, 1}}};
  struct Row {
    std::string method, title;
    std::vector<std::pair<std::string, std::string>> parameters;
  };
  const auto posed = symmetric_pose(cage, false);
  const auto others = other_diagonals(cage);
  for (const Row& row : {Row{"green", "Green", {}}, Row{"biharmonic_1_3", "biharmonic (1,3)", {{"normals", "rms"}}},
                         Row{"somigliana", "Somigliana", {{"variant", "local"}, {"gamma", "1"}}}}) {
    const auto add = [&](const std::string& of, const std::string& suffix, bool keeps_quads,
                         std::shared_ptr<const Cage> in) {
      sheet.panels.push_back({.title = fmt::format("{}, {}", row.title, of),
                              .file = row.method + suffix,
                              .method = (keeps_quads ? "quad_" : "") + row.method,
                              .parameters = row.parameters,
                              .posed = posed,
                              .shows_diagonals = !keeps_quads,
                              .cage = std::move(in)});
    };
    add("first diagonals", ".first", false, nullptr);
    add("other diagonals", ".other", false, others);
    add("quads kept", ".quads", true, nullptr);
  }
  return sheet;
}

}  // namespace

std::unique_ptr<const PaperFigure> symmetry_figure() {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  DeformedPlan plan{.name = "symmetry",
                    .cage = cage,
                    .mesh = rounded_box({0.47, 0.47, 0.47}, 0.1, 0.06),
                    .sheets = {},
                    .is_symmetric = true};
  SheetPlan sheet{
      .name = "t18-symmetry",
      .heading = "Quads, and their triangulation",
      .source = "[T18] Figures 1, 11 and 12",
      .text =
          "Two poses of a cube, each symmetric between left and right. The diagonals of the triangulated cage are not "
          "symmetric, and so are not the images of mean value coordinates on it; those of quads are. The asymmetry is "
          "the largest distance between the image of a point's mirror image and the mirror image of its image, over "
          "the cage's size.",
      .columns = 3,
      .panels = {},
      .view = {{0, -1, 0.55}, {0, 0, 1}}};
  for (const bool tapered : {true, false}) {
    const std::string suffix = tapered ? ".taper" : ".spread";
    const auto posed = symmetric_pose(*cage, tapered);
    sheet.panels.push_back({.title = tapered ? "at rest, triangulated" : "at rest, quads",
                            .file = "rest" + suffix,
                            .shows_diagonals = tapered});
    sheet.panels.push_back({.title = "mean value, triangulated",
                            .file = "mean_value" + suffix,
                            .method = "mean_value",
                            .posed = posed,
                            .shows_diagonals = true});
    sheet.panels.push_back({.title = "mean value, quads",
                            .file = "quad_mean_value" + suffix,
                            .method = "quad_mean_value",
                            .posed = posed});
  }
  plan.sheets.push_back(std::move(sheet));
  plan.sheets.push_back(diagonals_sheet(*cage));
  return deformed_figure(std::move(plan));
}

}  // namespace cageproof::validation
