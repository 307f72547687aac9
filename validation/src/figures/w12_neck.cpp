// SPDX-License-Identifier: MIT
// [W12] Figure 7: points that are held shorten, draw out and bend a long neck.
#include "embedded_figures.h"
#include "plane_shapes.h"

#include <fmt/format.h>

#include <span>

namespace cageproof::validation {
namespace {

// Feet, rump, shoulder, and the head's two ends, which move; the neck's middle where it is bent.
deformation::Constraints held(const Cage& cage, const Vec3<double>& head, const std::vector<Vec3<double>>& neck) {
  deformation::Constraints found;
  for (const Vec3<double>& at : {Vec3<double>(0.3, 0.3, 0), {2.7, 0.3, 0}, {0.3, 2.2, 0}, {2.7, 2.2, 0}})
    found.positions.push_back({at, at});
  for (const Vec3<double>& at : {Vec3<double>(2.7, 5.8, 0), {3.9, 5.8, 0}}) found.positions.push_back({at, at + head});
  for (const Vec3<double>& to : neck) found.positions.push_back({{2.7, 4.1, 0}, to});
  // Along the middles of limbs and body: variational maps are drawn to rotations there.
  for (const Vec3<double>& at : {Vec3<double>(0.3, 0.9, 0),
                                 {2.7, 0.9, 0},
                                 {0.9, 2.2, 0},
                                 {1.5, 2.2, 0},
                                 {2.1, 2.2, 0},
                                 {2.7, 2.9, 0},
                                 {2.7, 3.5, 0},
                                 {2.7, 4.1, 0},
                                 {2.7, 4.7, 0},
                                 {2.7, 5.3, 0},
                                 {3.3, 5.8, 0}})
    found.rotations.push_back(at);
  // Beside the cage they bend little.
  found.hessians = beside_edges(cage, 0.01, 3);
  return found;
}

}  // namespace

std::unique_ptr<const PaperFigure> neck_figure() {
  const auto cage = std::make_shared<const Cage>(plane_animal());
  struct Neck {
    std::string title, file;
    deformation::Constraints constraints;
  };
  const std::vector<Neck> necks{{"at rest", "still", held(*cage, {0, 0, 0}, {})},
                                {"shortened", "short", held(*cage, {0, -1.4, 0}, {})},
                                {"drawn out", "long", held(*cage, {0, 1.2, 0}, {})},
                                {"bent", "bent", held(*cage, {0, -1, 0}, {{3.5, 3.7, 0}})}};
  SheetPlan sheet{.name = "w12-neck",
                  .heading = "A long neck, by points that are held",
                  .source = "[W12] Figure 7",
                  .text =
                      "Points are held (dots), and no polygon is given. Above, variational harmonic maps stay "
                      "near rotations along the middles of limbs, so that they keep lengths: a neck that is to be "
                      "shortened evades to the side, and the body bends with it. Below, thickness is kept instead "
                      "of length: the polygon found (blue) shortens or lengthens the neck, and bends it where a "
                      "third point asks for that.",
                  .columns = 4,
                  .panels = {}};
  sheet.panels.push_back({.title = "at rest", .file = "rest", .constraints = necks[0].constraints});
  for (const Neck& neck : std::span(necks).subspan(1))
    sheet.panels.push_back({.title = fmt::format("variational harmonic, {}", neck.title),
                            .file = "variational." + neck.file,
                            .method = "variational",
                            .parameters = {{"subspace", "harmonic"}, {"beta", "0.1"}},
                            .constraints = neck.constraints});
  for (const Neck& neck : necks) {
    auto positions = neck.constraints;
    positions.rotations.clear();
    positions.hessians.clear();
    sheet.panels.push_back({.title = fmt::format("thickness, {}", neck.title),
                            .file = "thickness." + neck.file,
                            .method = "thickness",
                            .constraints = std::move(positions)});
  }
  DeformedPlan plan{.name = "neck", .cage = cage, .mesh = animal_mesh(*cage), .sheets = {}};
  plan.sheets.push_back(std::move(sheet));
  return deformed_figure(std::move(plan));
}

}  // namespace cageproof::validation
