// SPDX-License-Identifier: MIT
// The papers' figures of the plane: their meshes and measures, and what the papers say of them.
#include "figure_panels.h"

#include "figures/embedded_figures.h"
#include "figures/plane_measures.h"
#include "figures/plane_notes.h"
#include "figures/plane_shapes.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/deformation/deformer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace cageproof::validation::plane_figures_test {
namespace {

constexpr const char* kMiss = "largest distance of the border from the posed cage over cage size";
constexpr const char* kFolded = "share of triangles turned over";

reports::FigureSheet sheet_of(const PaperFigure& figure, std::size_t number = 0) {
  FigureFindings found;
  for (int part = 0; part < figure.parts(); ++part) found.merge(figure.part(part, 1));
  EXPECT_TRUE(figure.is_in(found));
  // Each finding is needed.
  for (const auto& [key, mesh] : FigureFindings(found)) {
    found.erase(key);
    EXPECT_FALSE(figure.is_in(found)) << key;
    found[key] = mesh;
  }
  return figure.sheets(found).at(number);
}

double shoelace(const std::vector<Vec3<double>>& points, const std::vector<int>& face) {
  double twice = 0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3<double>&a = points[face[k]], &b = points[face[(k + 1) % face.size()]];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

TEST(PlaneFigures, meshes_fill_their_polygons_without_gaps) {
  const Cage square = plane_square(), star = plane_star(), trousers = plane_trousers(), animal = plane_animal();
  // Its patches run along their common edge in opposite directions.
  const Cage pair = polygon_of("pair", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}});
  for (const auto& [cage, mesh] : {std::pair{&square, square_mesh(square, 6)},
                                   {&star, star_mesh(star)},
                                   {&trousers, trousers_mesh(trousers)},
                                   {&animal, animal_mesh(animal)},
                                   {&pair, patched(pair, {}, {{{0, 1, 4, 5}, 3, 3}, {{3, 4, 1, 2}, 3, 3}})}}) {
    std::vector<int> all(cage->vertices().size());
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
    double area = 0;
    std::map<std::pair<int, int>, int> edges;
    for (const auto& face : mesh.mesh.faces) {
      EXPECT_GT(shoelace(mesh.mesh.vertices, face), 0) << cage->name();
      area += shoelace(mesh.mesh.vertices, face);
      for (std::size_t k = 0; k < face.size(); ++k) ++edges[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
    EXPECT_NEAR(area / shoelace(cage->vertices(), all), 1, 1e-4) << cage->name();
    // The edges of one face are the border: a gap between patches would be one inside.
    std::vector<Vec3<double>> border;
    for (const auto& [edge, faces] : edges) {
      EXPECT_LE(faces, 2);
      if (faces == 1) border.push_back((mesh.mesh.vertices[edge.first] + mesh.mesh.vertices[edge.second]) / 2);
    }
    for (const Vec3<double>& middle : border)
      EXPECT_TRUE(miss_of_cage(*cage, cage->vertices(), {middle}, {middle}).has_value()) << cage->name();
    EXPECT_EQ(mesh.tones.size(), mesh.mesh.faces.size());
  }
}

TEST(PlaneFigures, measures_of_known_maps) {
  const Cage square = plane_square();
  const TonedMesh mesh = square_mesh(square, 4);
  const auto& rest = mesh.mesh.vertices;
  std::vector<Vec3<double>> posed = square.vertices(), images = rest;
  for (auto* points : {&posed, &images})
    for (Vec3<double>& p : *points) p = Vec3<double>(2 * p[0] + p[1] + 3, p[1] - p[0], 0);
  EXPECT_LT(*miss_of_cage(square, posed, rest, images), 1e-5);
  EXPECT_EQ(folded_share(mesh.mesh.faces, images), 0);
  // One corner's image is moved by a half: the border's largest distance.
  images.front()[0] -= 0.5;
  EXPECT_NEAR(*miss_of_cage(square, posed, rest, images), 0.5, 1e-4);
  EXPECT_FALSE(miss_of_cage(square, posed, {{0.5, 0.5, 0}}, {{0, 0, 0}}).has_value());
  for (Vec3<double>& p : images) p[0] = -p[0];
  EXPECT_EQ(folded_share(mesh.mesh.faces, images), 1);
  // The corner drawn through the cell turns one of its two triangles over, of 32.
  images = rest;
  images.front() = {0.3, 0.1, 0};
  EXPECT_EQ(folded_share(mesh.mesh.faces, images), 1.0 / 32);
}

// By trying all pairs of directions.
TEST(PlaneFigures, changes_of_angles_are_those_of_the_worst_directions) {
  EXPECT_NEAR(angle_change({0.6, 0.8, 0}, {-0.8, 0.6, 0}), 0, 1e-12);
  EXPECT_EQ(angle_change({1, 0, 0}, {0, -1, 0}), 180);
  EXPECT_NEAR(angle_change({2, 0, 0}, {0, 1, 0}), 2 * std::asin(1.0 / 3) * 180 / std::numbers::pi, 1e-12);
  const Vec3<double> by_x(1.1, 0.4, 0), by_y(-0.3, 0.7, 0);
  constexpr int steps = 720;
  std::vector<double> turned;
  for (int k = 0; k < steps; ++k) {
    const double angle = k * std::numbers::pi / steps;
    const Vec3<double> image = std::cos(angle) * by_x + std::sin(angle) * by_y;
    turned.push_back(std::remainder(std::atan2(image[1], image[0]) - angle, 2 * std::numbers::pi));
  }
  const auto [least, most] = std::ranges::minmax(turned);
  EXPECT_NEAR(angle_change(by_x, by_y), (most - least) * 180 / std::numbers::pi, 1e-2);
}

TEST(PlaneFigures, mean_value_coordinates_push_the_still_leg_and_others_do_not) {
  const reports::FigureSheet sheet = sheet_of(*trousers_figure());
  const auto moved = [&](const char* file) {
    return measured(panel_of(sheet, file), "largest displacement of the still leg over cage size");
  };
  EXPECT_GT(moved("mean_value"), 3 * moved("harmonic"));
  EXPECT_GT(moved("mean_value"), 3 * moved("biharmonic_boundary.unit"));
  // Away from the leg that is lifted to the right.
  const auto &rest = panel_of(sheet, "rest").data.vertices, &pushed = panel_of(sheet, "mean_value").data.vertices;
  double most = 0, least = 0;
  for (std::size_t p = 0; p < rest.size(); ++p)
    if (rest[p][0] < 1.7 && rest[p][1] < 1.5) {
      most = std::max(most, pushed[p][0] - rest[p][0]);
      least = std::min(least, pushed[p][0] - rest[p][0]);
    }
  EXPECT_GT(-least, 3 * most);
  EXPECT_LT(measured(panel_of(sheet, "mean_value"), kMiss), 1e-4);
  EXPECT_GT(measured(panel_of(sheet, "green"), kMiss), 0.02);
}

TEST(PlaneFigures, normal_derivatives_alone_move_the_square_within) {
  const reports::FigureSheet sheet = sheet_of(*square_figure(), 0);
  const auto &rest = panel_of(sheet, "rest").data.vertices, &same = panel_of(sheet, "identity").data.vertices;
  for (std::size_t p = 0; p < rest.size(); ++p) EXPECT_LT((rest[p] - same[p]).norm(), 1e-10);
  EXPECT_GT(measured(panel_of(sheet, "sixfold"), kFolded), 0.02);
  EXPECT_EQ(measured(panel_of(sheet, "identity"), kFolded), 0);
  // Maps of the square into itself keep its middle by symmetry, and turn it where derivatives are turned.
  const Cage square = plane_square();
  const auto deformer = deformation::prepare_deformer<double>(deformation::deform_method_named("biharmonic_boundary"),
                                                              square, {.parameters = {0, 8}});
  const double s = std::sqrt(0.75);
  const auto pose = deformer->pose({square.vertices(), {{s, -0.5, 0}, {0.5, s, 0}, {-s, 0.5, 0}, {-0.5, -s, 0}}});
  const auto& turned = panel_of(sheet, "turned").data.vertices;
  for (const std::size_t p : {std::size_t{40}, rest.size() / 2}) {
    const auto image = deformer->images(*pose, std::span(&rest[p], 1), 0).tensors[0];
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(image[c], turned[p][c], 1e-12);
  }
}

TEST(PlaneFigures, unit_normals_fold_a_thin_rhombus_and_least_laplacians_do_not) {
  const reports::FigureSheet sheet = sheet_of(*square_figure(), 1);
  EXPECT_GT(measured(panel_of(sheet, "biharmonic_boundary.unit"), kFolded), 0.02);
  EXPECT_EQ(measured(panel_of(sheet, "biharmonic_boundary.ahap"), kFolded), 0);
  EXPECT_EQ(measured(panel_of(sheet, "harmonic"), kFolded), 0);
}

TEST(PlaneFigures, complex_biharmonic_maps_follow_the_star_and_keep_angles_next_to_its_border) {
  const reports::FigureSheet sheet = sheet_of(*star_figure());
  const auto angles = [&](const char* file) {
    return measured(panel_of(sheet, file), "mean change of angles next to the border, in degrees");
  };
  EXPECT_LT(angles("cauchy"), 1e-5);
  EXPECT_LT(angles("biharmonic_boundary.complex"), angles("harmonic") / 3);
  EXPECT_LT(angles("biharmonic_boundary.complex"),
            measured(panel_of(sheet, "biharmonic_boundary.complex"), "mean change of angles further in, in degrees"));
  EXPECT_GT(measured(panel_of(sheet, "cauchy"), kMiss),
            10 * measured(panel_of(sheet, "biharmonic_boundary.complex"), kMiss));
}

TEST(PlaneFigures, a_blend_lies_between_its_variants) {
  const reports::FigureSheet sheet = sheet_of(*star_variants_figure());
  const auto &global = panel_of(sheet, "global").data.vertices, &local = panel_of(sheet, "local").data.vertices,
             &blend = panel_of(sheet, "blend").data.vertices;
  double apart = 0, off = 0;
  for (std::size_t p = 0; p < global.size(); ++p) {
    apart = std::max(apart, (global[p] - local[p]).norm());
    off = std::max(off, ((global[p] + local[p]) / 2 - blend[p]).norm());
  }
  EXPECT_GT(apart, 0.05);
  EXPECT_LT(off, apart / 3);
}

TEST(PlaneFigures, an_infinite_ratio_is_green_in_the_plane) {
  const reports::FigureSheet sheet = sheet_of(*infinite_ratio_figure());
  const auto from_green = [&](const char* file) {
    return measured(panel_of(sheet, file), "largest distance from green over cage size");
  };
  EXPECT_LT(from_green("local.nuinf"), 1e-12);
  EXPECT_GT(from_green("local.nu0.3"), 1e-2);
}

TEST(PlaneFigures, pictures_of_necks_hold_what_is_held) {
  const reports::FigureSheet sheet = sheet_of(*neck_figure());
  ASSERT_EQ(sheet.panels.size(), 8U);
  for (const auto& panel : sheet.panels) {
    EXPECT_EQ(panel.cage.empty(), panel.file.starts_with("variational")) << panel.file;
    EXPECT_GE(panel.marks.size(), 6U);
  }
  // Measured along its middle, the neck is shortened to half by thickness; variational maps resist.
  const auto& rest = panel_of(sheet, "rest").data.vertices;
  const auto length = [&](const char* file) {
    std::vector<Vec3<double>> middle;
    for (int k = 0; k <= 16; ++k) {
      const Vec3<double> at(2.7, 2.8 + 2.6 * k / 16, 0);
      const auto nearest = std::ranges::min_element(rest, {}, [&](const Vec3<double>& p) { return (p - at).norm(); });
      middle.push_back(panel_of(sheet, file).data.vertices[nearest - rest.begin()]);
    }
    double sum = 0;
    for (std::size_t k = 1; k < middle.size(); ++k) sum += (middle[k] - middle[k - 1]).norm();
    return sum;
  };
  EXPECT_LT(length("thickness.short"), 0.6 * length("rest"));
  EXPECT_GT(length("variational.short"), 1.3 * length("thickness.short"));
  EXPECT_NEAR(length("thickness.still"), length("rest"), 1e-3);
}

// Against differences of coordinates on either side.
TEST(PlaneFigures, the_seam_has_no_kink_with_biharmonic_coordinates) {
  const reports::FigureSheet sheet = sheet_of(*seam_figure());
  const auto jump = [&](const char* file) {
    return measured(panel_of(sheet, file), "largest jump of the derivative across the seam");
  };
  EXPECT_GT(jump("harmonic"), 0.5);
  EXPECT_LT(jump("biharmonic"), 1e-6);
  const char* const outside = "share of inner vertices outside the posed cage";
  EXPECT_GT(measured(panel_of(sheet, "whole"), outside), 0.02);
  for (const char* file : {"harmonic", "biharmonic"}) {
    EXPECT_EQ(measured(panel_of(sheet, file), outside), 0) << file;
    EXPECT_EQ(measured(panel_of(sheet, file), kFolded), 0) << file;
  }
  EXPECT_GT(measured(panel_of(sheet, "whole"), kFolded), 0);
}

}  // namespace
}  // namespace cageproof::validation::plane_figures_test
