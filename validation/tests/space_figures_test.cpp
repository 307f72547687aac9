// SPDX-License-Identifier: MIT
// [T18]'s and [T24]'s figures in space: what captions state, measured by other means, and what the papers claim.
#include "figure_panels.h"

#include "figures/bilinear_surface.h"
#include "figures/embedded_figures.h"
#include "figures/figure_measures.h"
#include "figures/space_shapes.h"

#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/deformation/deformer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::validation::space_figures_test {
namespace {

std::vector<reports::FigureSheet> sheets_of(const PaperFigure& figure) {
  FigureFindings found;
  for (int part = 0; part < figure.parts(); ++part) found.merge(figure.part(part, 1));
  EXPECT_TRUE(figure.is_in(found));
  // Each finding is needed.
  for (const auto& [key, mesh] : FigureFindings(found)) {
    found.erase(key);
    EXPECT_FALSE(figure.is_in(found)) << key;
    found[key] = mesh;
  }
  return figure.sheets(found);
}

double off(const reports::FigureSheet& sheet, const std::string& file) {
  return measured(panel_of(sheet, file), "largest distance over cage size");
}

double turn(const reports::FigureSheet& sheet, const std::string& file) {
  return measured(panel_of(sheet, file), "sharpest turn that is added in degrees");
}

// The mean vector of a quad, side by side ([T18] Eq 16).
Vec3<double> mean_vector(const std::vector<Vec3<double>>& quad, const Vec3<double>& point) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3<double> a = quad[k] - point, b = quad[(k + 1) % 4] - point;
    const Vec3<double> n = b.cross(a);
    sum -= std::acos(a.dot(b) / (a.norm() * b.norm())) * n / (2 * n.norm());
  }
  return sum;
}

TEST(SpaceFigures, turns_are_those_that_a_map_adds) {
  // Three squares in a row.
  std::vector<Vec3<double>> flat;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) flat.emplace_back(i, j, 0);
  const std::vector<std::vector<int>> faces{{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}};
  const auto folded = [&](double degrees) {
    std::vector<Vec3<double>> at = flat;
    const double turn = degrees * std::numbers::pi / 180;
    for (std::size_t v = 4; v < 8; ++v) {
      const double along = at[v][0] - 1;
      at[v] = Vec3<double>(1 + along * std::cos(turn), at[v][1], along * std::sin(turn));
    }
    return at;
  };
  EXPECT_NEAR(added_turn(faces, flat, folded(40)), 40, 1e-9);
  EXPECT_NEAR(added_turn(faces, folded(15), folded(40)), 25, 1e-9);
  EXPECT_EQ(added_turn(faces, folded(40), flat), 0) << "edges that become flatter";
  std::vector<Vec3<double>> similar = folded(40);
  for (Vec3<double>& p : similar) p = Vec3<double>(-3 * p[1], 3 * p[0], 3 * p[2] + 7);
  EXPECT_NEAR(added_turn(faces, folded(40), similar), 0, 1e-9);
  std::vector<Vec3<double>> pressed = flat;
  for (const std::size_t v : {6, 7}) pressed[v] = pressed[v - 2];
  EXPECT_EQ(added_turn(faces, flat, pressed), 180);
}

TEST(SpaceFigures, quads_are_valid_where_every_projection_is_convex) {
  const auto figure = valid_quads_figure();
  const reports::FigureSheet sheet = sheets_of(*figure).at(0);
  ASSERT_EQ(sheet.panels.size(), 12U);
  for (const auto& [file, valid] : {std::pair{"convex", true},
                                    {"lifted", true},
                                    {"saddle", true},
                                    {"steep", false},
                                    {"arrowhead", false},
                                    {"bow-tie", false}}) {
    const auto& panel = panel_of(sheet, file);
    EXPECT_EQ(panel.facts.at(1), std::pair(std::string("valid"), std::string(valid ? "yes" : "no"))) << file;
    EXPECT_EQ(panel.note, valid ? "valid" : "not valid");
    // The exact decision, and the sines in double.
    Quad<double> quad;
    std::ranges::copy(panel.cage, quad.begin());
    EXPECT_EQ(!invalid_because(quad), valid);
    EXPECT_EQ(measured(panel_of(sheet, std::string(file) + ".projection"), "least sine of a projected angle") > 0,
              valid)
        << file;
  }
  EXPECT_NE(sheet.text.find("3 quads are valid"), std::string::npos);
  EXPECT_NEAR(least_convex_projection({{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}}).sine, 1, 1e-15);
}

TEST(SpaceFigures, projections_follow_the_mean_vector_to_the_quad) {
  const auto figure = projection_figure();
  const reports::FigureSheet sheet = sheets_of(*figure).at(0);
  for (const std::string file : {"above", "beside", "within", "near"}) {
    const auto& panel = panel_of(sheet, file + ".projection");
    const auto& samples = panel_of(sheet, file + ".samples");
    ASSERT_EQ(panel.marks.size(), 3U);
    const Vec3<double>&point = panel.marks[0], &hull = panel.marks[1], &quad = panel.marks[2];
    const bool inside = file == "within" || file == "near";
    if (inside) EXPECT_EQ(point, hull);
    else EXPECT_GT((hull - point).norm(), 0.01);
    const Vec3<double> along = mean_vector(panel.cage, hull).normalized();
    EXPECT_LT((quad - hull).cross(along).norm(), 1e-12) << file;
    ASSERT_EQ(samples.marks.size(), 25U);
    EXPECT_LT((samples.marks[12] - quad).norm(), 1e-12) << "the middle sample is the projection";
    const double u = measured(samples, "u"), v = measured(samples, "v");
    Quad<double> corners;
    std::ranges::copy(panel.cage, corners.begin());
    EXPECT_LT((bilinear_point(corners, u, v) - quad).norm(), 1e-12);
    EXPECT_LT((bilinear_point(corners, u / 2, v) - samples.marks[7]).norm(), 1e-12);
  }
}

TEST(SpaceFigures, panels_take_the_evaluation_that_they_name) {
  const reports::FigureSheet cut = sheets_of(*tessellation_figure()).at(0),
                             corrected = sheets_of(*norm_correction_figure()).at(0);
  const auto cage = plain_bar(1);
  for (const auto& [sheet, file] :
       {std::pair{&cut, "tessellated-2"}, {&corrected, "riemann-1-uncorrected"}, {&cut, "quad_mean_value"}}) {
    const auto& panel = panel_of(*sheet, file);
    const CageCoordinates coordinates(cage, coordinate_kind_named("quad_mean_value"),
                                      {.evaluation = std::string(file) == "quad_mean_value" ? "" : file});
    const auto& rest = panel_of(*sheet, "rest").data.vertices;
    for (std::size_t p = 0; p < rest.size(); p += 97) {
      const auto values = coordinates.at<double>(std::span(&rest[p], 1), 0)[0].tensors[0];
      Vec3<double> image = Vec3<double>::Zero();
      for (std::size_t v = 0; v < 8; ++v) image += values[v] * panel.cage[v];
      EXPECT_LT((image - panel.data.vertices[p]).norm(), 1e-12) << file;
    }
  }
}

TEST(SpaceFigures, tessellation_converges_and_the_norm_correction_serves_coarse_grids) {
  const reports::FigureSheet cut = sheets_of(*tessellation_figure()).at(0),
                             corrected = sheets_of(*norm_correction_figure()).at(0);
  EXPECT_GT(off(cut, "tessellated-1"), 2 * off(cut, "tessellated-2"));
  EXPECT_GT(off(cut, "tessellated-2"), 2 * off(cut, "tessellated-6"));
  EXPECT_GT(turn(cut, "tessellated-1"), 2 * turn(cut, "quad_mean_value"));
  EXPECT_GT(off(corrected, "riemann-1-uncorrected"), 10 * off(corrected, "riemann-1"));
  EXPECT_GT(off(corrected, "riemann-4-uncorrected"), 10 * off(corrected, "riemann-1"));
  EXPECT_LT(off(corrected, "riemann-60-uncorrected"), off(corrected, "riemann-1"));
}

TEST(SpaceFigures, coordinates_of_moved_vertices_are_negative_only_by_mean_value) {
  const auto figure = fork_figure();
  const reports::FigureSheet sheet = sheets_of(*figure).at(0);
  const auto least = [&](const std::string& file) {
    return measured(panel_of(sheet, file), "least coordinate of moved vertices");
  };
  EXPECT_LT(least("quad_mean_value"), -0.02);
  EXPECT_GT(least("harmonic"), -5e-3) << "what boundary elements may err by";
  EXPECT_GT(least("maximum_entropy"), -1e-12);
  // The sum of the coordinates, and faces that are dark by its sign.
  const Cage cage = fork_cage();
  const CageCoordinates coordinates(cage, coordinate_kind_named("quad_mean_value"), CoordinateOptions{});
  const auto& rest = sheet.panels.at(0).data.vertices;
  const auto& panel = panel_of(sheet, "quad_mean_value");
  const auto& shares = panel.data.arrays.at(1).values;
  ASSERT_EQ(shares.size(), rest.size());
  const auto tables = coordinates.at<double>(std::span(rest), 0);
  for (std::size_t p = 0; p < rest.size(); ++p) {
    double sum = 0;
    for (std::size_t v = 0; v < cage.vertices().size(); ++v)
      if (cage.vertices()[v][0] > 0 && cage.vertices()[v][2] == 2)
        sum += tables[0].tensors[0][p * tables[0].stride[0] + v];
    EXPECT_NEAR(sum, shares[p], 1e-12);
  }
  for (std::size_t f = 0; f < panel.data.faces.size(); ++f) {
    double smallest = 1;
    for (const int v : panel.data.faces[f]) smallest = std::min(smallest, shares[v]);
    EXPECT_EQ(panel.tones[f] != 0, smallest < -0.01);
  }
  EXPECT_TRUE(std::ranges::count(panel.tones, 1) > 20);
  EXPECT_EQ(std::ranges::count(panel_of(sheet, "harmonic").tones, 1), 0);
}

TEST(SpaceFigures, kept_quads_have_no_diagonals) {
  const reports::FigureSheet pencil = sheets_of(*triquad_figure()).at(0);
  EXPECT_GT(turn(pencil, "mean_value.twisted"), 2 * turn(pencil, "quad_mean_value.twisted"));
  const reports::FigureSheet box = sheets_of(*twisted_box_figure()).at(0);
  EXPECT_GT(turn(box, "mean_value"), 4 * turn(box, "quad_mean_value"));
  const reports::FigureSheet tower = sheets_of(*spherical_figure()).at(0);
  EXPECT_GT(turn(tower, "spherical_mean_value"), 4 * turn(tower, "quad_mean_value"));
}

TEST(SpaceFigures, free_alignment_keeps_affine_maps_and_hard_alignment_does_not) {
  const auto sheets = sheets_of(*biharmonic_choices_figure());
  const reports::FigureSheet& sheet = sheets.at(1);
  for (const std::string method : {"aaap", "tp"}) {
    EXPECT_LT(off(sheet, method + ".free.sheared"), 1e-9) << method;
    EXPECT_GT(off(sheet, method + ".hard.sheared"), 1e-3) << method;
  }
  // Larger weights of positions follow the cage more closely, which mean value coordinates meet.
  const reports::FigureSheet& gamma = sheets.at(0);
  for (const std::string pose : {".bent", ".twisted"}) {
    EXPECT_GT(off(gamma, "gamma0.01" + pose), off(gamma, "gamma1" + pose));
    EXPECT_GT(off(gamma, "gamma1" + pose), off(gamma, "gamma100" + pose));
  }
}

TEST(SpaceFigures, maps_of_least_energy_are_shown_in_their_cages) {
  const reports::FigureSheet sheet = sheets_of(*variational_figure()).at(0);
  ASSERT_EQ(sheet.panels.size(), 4U);
  for (const reports::FigurePanel& panel : sheet.panels) {
    EXPECT_EQ(panel.file.substr(panel.file.find('.') + 1), std::to_string(panel.cage.size()));
    EXPECT_EQ(panel.cage, plain_bar((static_cast<int>(panel.cage.size()) - 4) / 4).vertices());
    EXPECT_EQ(panel.marks.size(), 8U);
    EXPECT_LT(turn(sheet, panel.file), 15) << "smooth: " << panel.file;
  }
}

TEST(SpaceFigures, quadrature_makes_spikes_that_more_points_make_smaller) {
  const reports::FigureSheet sheet = sheets_of(*spikes_figure()).at(0);
  EXPECT_GT(off(sheet, "three-quad-75"), 2 * off(sheet, "three-quad-300"));
  EXPECT_GT(off(sheet, "three-quad-300"), 1e-3);
  EXPECT_GT(turn(sheet, "three-quad-75"), 2 * turn(sheet, "closed_form"));
}

TEST(SpaceFigures, blends_lie_between_variants_and_infinite_ratios_are_not_green) {
  const auto sheets = sheets_of(*bar_variants_figure());
  const auto images = [](const reports::FigureSheet& sheet, const std::string& file) {
    return panel_of(sheet, file).data.vertices;
  };
  const auto global = images(sheets.at(0), "global"), local = images(sheets.at(0), "local"),
             blend = images(sheets.at(0), "blend");
  double apart = 0, middle = 0;
  for (std::size_t p = 0; p < blend.size(); ++p) {
    apart = std::max(apart, (global[p] - local[p]).norm());
    middle = std::max(middle, ((global[p] + local[p]) / 2 - blend[p]).norm());
  }
  EXPECT_GT(apart, 0.05);
  EXPECT_LT(middle, apart / 3);
  for (const char* variant : {"global", "local"}) {
    const auto of = [&](const char* nu) { return off(sheets.at(1), fmt::format("{}.nu{}", variant, nu)); };
    EXPECT_GT(of("inf"), 1e-2) << variant;
    EXPECT_LT(of("inf"), of("0.3")) << variant;
  }
}

TEST(SpaceFigures, panels_are_compared_only_with_panels_of_their_sheet) {
  DeformedPlan plan{.name = "bad", .cage = std::make_shared<const Cage>(plain_bar(1)), .mesh = {}, .sheets = {}};
  plan.sheets = {{.name = "bad", .heading = "", .source = "", .text = "", .columns = 1, .panels = {}}};
  plan.sheets[0].panels.push_back({.title = "", .file = "x", .method = "mean_value", .compared_with = "y"});
  EXPECT_THROW(deformed_figure(plan), std::invalid_argument);
}

}  // namespace
}  // namespace cageproof::validation::space_figures_test
