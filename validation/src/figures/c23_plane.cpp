// SPDX-License-Identifier: MIT
// [C23]'s figures of posed polygons.
#include "embedded_figures.h"
#include "plane_shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cageproof::validation {
namespace {

// Mean value, Green and both variants of Somigliana coordinates with nu = 0.1, gamma = 2.
SheetPlan four_methods(const std::string& name, const std::string& shape, const std::vector<Vec3<double>>& posed) {
  SheetPlan sheet{.name = name,
                  .heading = fmt::format("{} by four methods", shape),
                  .source = fmt::format("[C23] Figure 10, its {}", name == "c23-l" ? "L" : "hexagon"),
                  .text =
                      "Mean value and Green coordinates, and Somigliana coordinates with Poisson's ratio 0.1 and "
                      "bulging γ = 2. The global variant is more muted than the local one, and both answer like "
                      "an elastic body: what is pressed bulges out.",
                  .columns = 5,
                  .panels = {{.title = "at rest", .file = "rest"},
                             {.title = "mean value", .file = "mean_value", .method = "mean_value", .posed = posed},
                             {.title = "Green", .file = "green", .method = "green", .posed = posed}}};
  for (const std::string variant : {"global", "local"})
    sheet.panels.push_back({.title = fmt::format("Somigliana, {}", variant),
                            .file = fmt::format("somigliana.{}", variant),
                            .method = "somigliana",
                            .parameters = {{"variant", variant}, {"nu", "0.1"}, {"gamma", "2"}},
                            .posed = posed});
  return sheet;
}

Cage plane_hexagon() {
  std::vector<Vec3<double>> vertices;
  vertices.reserve(6);
  for (int k = 0; k < 6; ++k)
    vertices.emplace_back(std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3), 0);
  return polygon_of("hexagon", std::move(vertices));
}

}  // namespace

std::unique_ptr<const PaperFigure> star_variants_figure() {
  const auto cage = std::make_shared<const Cage>(plane_star());
  const std::vector<Vec3<double>> posed = lifted_star(*cage);
  SheetPlan variants{.name = "c23-star",
                     .heading = "A star by Somigliana coordinates: global, local and between",
                     .source = "[C23] Figure 4, its star",
                     .text =
                         "Poisson's ratio 0.38, no bulging (γ = 0). The global variant gives all edges one "
                         "rotation and one stretch, and is muted; the local one gives each its own, and may fold; the "
                         "blend takes the mean of both, and lies between them.",
                     .columns = 4,
                     .panels = {{.title = "at rest", .file = "rest"}}};
  for (const std::string variant : {"global", "blend", "local"})
    variants.panels.push_back({.title = variant,
                               .file = variant,
                               .method = "somigliana",
                               .parameters = {{"variant", variant}, {"nu", "0.38"}, {"gamma", "0"}},
                               .posed = posed});
  DeformedPlan plan{.name = "star variants", .cage = cage, .mesh = star_mesh(*cage), .sheets = {}};
  plan.sheets.push_back(std::move(variants));
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> hexagon_figure() {
  constexpr int cells = 10;
  const auto cage = std::make_shared<const Cage>(plane_hexagon());
  // Pressed from the left, and its right corner drawn out.
  std::vector<Vec3<double>> posed = cage->vertices();
  posed[0] = {1.7, 0.3, 0};
  posed[2] = {-0.3, 0.95, 0};
  posed[3] = {-0.35, 0, 0};
  posed[4] = {-0.3, -0.95, 0};
  DeformedPlan plan{
      .name = "hexagon",
      .cage = cage,
      .mesh = patched(*cage, {Vec3<double>::Zero()},
                      {{{6, 5, 0, 1}, cells, cells}, {{6, 1, 2, 3}, cells, cells}, {{6, 3, 4, 5}, cells, cells}}),
      .sheets = {}};
  plan.sheets.push_back(four_methods("c23-hexagon", "A hexagon", posed));
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> l_figure() {
  constexpr int cells = 12;
  const auto cage = std::make_shared<const Cage>(
      polygon_of("L", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}));
  // One limb is bent upwards, the other pressed.
  const std::vector<Vec3<double>> posed{{0, 0, 0},       {1, 0, 0},     {1.9, 0.55, 0}, {1.4, 1.35, 0},
                                        {0.95, 1.05, 0}, {1.1, 1.5, 0}, {-0.1, 1.5, 0}, {0, 1, 0}};
  DeformedPlan plan{
      .name = "L",
      .cage = cage,
      .mesh = patched(*cage, {},
                      {{{0, 1, 4, 7}, cells, cells}, {{1, 2, 3, 4}, cells, cells}, {{7, 4, 5, 6}, cells, cells}}),
      .sheets = {}};
  plan.sheets.push_back(four_methods("c23-l", "An L", posed));
  return deformed_figure(std::move(plan));
}

std::unique_ptr<const PaperFigure> infinite_ratio_figure() {
  const auto cage = std::make_shared<const Cage>(plane_animal());
  // The neck drawn out and bent forwards, the legs apart.
  std::vector<Vec3<double>> posed = cage->vertices();
  for (const int v : {8, 15}) posed[v] += Vec3<double>(0.3, 0.3, 0);
  for (const int v : {9, 10, 11, 12, 13, 14}) posed[v] += Vec3<double>(1.1, 0.3, 0);
  for (const int v : {0, 1}) posed[v] += Vec3<double>(-0.5, 0.1, 0);
  for (const int v : {4, 5}) posed[v] += Vec3<double>(0.5, 0.1, 0);
  SheetPlan sheet{.name = "c23-infinite-ratio",
                  .heading = "Poisson's ratio up to infinity, against Green coordinates",
                  .source = "[C23] Figure 7, its upper row",
                  .text =
                      "No bulging (γ = 0). Captions state how far images are from those of Green coordinates (by the "
                      "mean of stretches): with an infinite Poisson's ratio they are the same in the plane, by either "
                      "variant. In space they are not.",
                  .columns = 3,
                  .panels = {}};
  const auto somigliana = [&](const std::string& variant, const std::string& shown, const std::string& nu) {
    sheet.panels.push_back({.title = fmt::format("Somigliana, {}, ν = {}", variant, shown),
                            .file = fmt::format("{}.nu{}", variant, nu),
                            .method = "somigliana",
                            .parameters = {{"variant", variant}, {"nu", nu}, {"gamma", "0"}},
                            .posed = posed,
                            .compared_with = "green"});
  };
  sheet.panels.push_back({.title = "at rest", .file = "rest"});
  somigliana("global", "0.3", "0.3");
  somigliana("global", "∞", "inf");
  sheet.panels.push_back({.title = "Green", .file = "green", .method = "green", .posed = posed});
  somigliana("local", "0.3", "0.3");
  somigliana("local", "∞", "inf");
  DeformedPlan plan{.name = "infinite ratio", .cage = cage, .mesh = animal_mesh(*cage), .sheets = {}};
  plan.sheets.push_back(std::move(sheet));
  return deformed_figure(std::move(plan));
}

}  // namespace cageproof::validation
