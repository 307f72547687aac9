// SPDX-License-Identifier: MIT
// The papers' figures: what is drawn is what deformers do, and captions say what is drawn.
#include "figure_panels.h"

#include "cageproof/validation/paper_figures.h"
#include "figures/embedded_figures.h"
#include "figures/figure_measures.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/enclosed.h"
#include "cageproof/core/input_error.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/reports/journal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace cageproof::validation::paper_figures_test {
namespace {

namespace fs = std::filesystem;

FigureFindings all_of(const PaperFigure& figure, int jobs = 1) {
  FigureFindings found;
  for (int part = 0; part < figure.parts(); ++part) found.merge(figure.part(part, jobs));
  return found;
}

// By Gauss's theorem, each face as a fan around its centroid: unlike the sum of tetrahedra from one vertex.
double volume(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces) {
  double sum = 0;
  for (const auto& face : faces) {
    Vec3<double> middle = Vec3<double>::Zero();
    for (const int v : face) middle += vertices[v] / static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3<double>&a = vertices[face[k]], &b = vertices[face[(k + 1) % face.size()]];
      sum += (a - middle).cross(b - middle)[2] * (a[2] + b[2] + middle[2]) / 6;
    }
  }
  return sum;
}

double content(const Mesh& mesh, const std::vector<Vec3<double>>& vertices, int dimension) {
  return content_of({mesh.faces, {}, dimension}, vertices, {.simplices = dimension == 3 ? 6 : 2}).value;
}

TEST(PaperFigures, rounded_boxes_are_closed_symmetric_and_point_outward) {
  const TonedMesh box = rounded_box({0.4, 0.3, 0.9}, 0.1, 0.05);
  EXPECT_EQ(asymmetry(box.mesh.vertices, box.mesh.vertices), 0);
  EXPECT_EQ(box.tones.size(), box.mesh.faces.size());
  std::set<std::pair<int, int>> edges;
  for (const auto& face : box.mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      EXPECT_TRUE(edges.insert({face[k], face[(k + 1) % face.size()]}).second);
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
  // Rounding takes away a little of the box.
  const double whole = 8 * 0.4 * 0.3 * 0.9, found = content(box.mesh, box.mesh.vertices, 3);
  EXPECT_NEAR(found, volume(box.mesh.vertices, box.mesh.faces), 1e-12 * whole);
  EXPECT_LT(found, whole);
  EXPECT_GT(found, 0.9 * whole);
}

TEST(PaperFigures, contents_and_asymmetries_of_known_maps) {
  const TonedMesh box = rounded_box({0.4, 0.3, 0.5}, 0.1, 0.05);
  std::vector<Vec3<double>> moved = box.mesh.vertices;
  for (Vec3<double>& p : moved) p = Vec3<double>(2 * p[0] + 0.1, 3 * p[1], -0.5 * p[2] + p[0] + 7);
  EXPECT_NEAR(content(box.mesh, moved, 3) / content(box.mesh, box.mesh.vertices, 3), -3, 1e-12);
  // A shift by 0.1 in x, and z that changes by x: a point and its mirror image are 0.2 and 2 x apart.
  double largest = 0;
  for (const Vec3<double>& p : box.mesh.vertices) largest = std::max(largest, std::hypot(0.2, 2 * p[0]));
  EXPECT_NEAR(asymmetry(box.mesh.vertices, moved), largest, 1e-14);
  const TonedMesh flat = grid(6, 2, 0.25);
  EXPECT_NEAR(content(flat.mesh, flat.mesh.vertices, 2), 12, 1e-12);
  EXPECT_THROW(asymmetry(flat.mesh.vertices, flat.mesh.vertices), std::invalid_argument);
}

TEST(PaperFigures, quads_that_are_kept_are_symmetric_and_neither_triangulation_is) {
  const auto figure = symmetry_figure();
  const reports::FigureSheet sheet = figure->sheets(all_of(*figure)).at(1);
  EXPECT_EQ(sheet.name, "quads-kept");
  for (const std::string method : {"green", "biharmonic_1_3", "somigliana"}) {
    const auto &first = panel_of(sheet, method + ".first"), &other = panel_of(sheet, method + ".other"),
               &quads = panel_of(sheet, method + ".quads");
    EXPECT_LT(measured(quads, "asymmetry over cage size"), 1e-14) << method;
    for (const auto* panel : {&first, &other}) EXPECT_GT(measured(*panel, "asymmetry over cage size"), 1e-2) << method;
    EXPECT_NE(first.data.vertices, other.data.vertices) << method;
    EXPECT_EQ(first.cage_faces.size(), 12U);
    EXPECT_EQ(quads.cage_faces.size(), 6U);
  }
}

TEST(PaperFigures, captions_of_symmetry_are_those_of_images_computed_alone) {
  const auto figure = symmetry_figure();
  const auto found = all_of(*figure);
  const reports::FigureSheet sheet = figure->sheets(found).at(0);
  const Cage cage = embedded_cage("cube");
  for (const std::string pose : {"taper", "spread"}) {
    const auto& rest = panel_of(sheet, "rest." + pose).data.vertices;
    for (const std::string method : {"mean_value", "quad_mean_value"}) {
      const reports::FigurePanel& panel = panel_of(sheet, fmt::format("{}.{}", method, pose));
      const CageCoordinates coordinates(cage, coordinate_kind_named(method), CoordinateOptions{});
      double largest = 0, moved = 0;
      for (std::size_t p = 0; p < rest.size(); p += 7) {
        // The image, and that of the mirror image, each by coordinates of one point.
        Vec3<double> images[2];
        for (const bool mirrored : {false, true}) {
          const Vec3<double> at(mirrored ? -rest[p][0] : rest[p][0], rest[p][1], rest[p][2]);
          const auto values = coordinates.at<double>(std::span(&at, 1), 0)[0].tensors[0];
          images[mirrored] = Vec3<double>::Zero();
          for (std::size_t v = 0; v < 8; ++v) images[mirrored] += values[v] * panel.cage[v];
        }
        EXPECT_NEAR((images[0] - panel.data.vertices[p]).norm(), 0, 1e-14);
        images[1][0] *= -1;
        largest = std::max(largest, (images[0] - images[1]).norm() / cage.size());
        moved = std::max(moved, (images[0] - rest[p]).norm() / cage.size());
      }
      const double stated = measured(panel, "asymmetry over cage size");
      EXPECT_LE(largest, stated + 1e-15);
      EXPECT_GE(largest, 0.8 * stated - 1e-15);
      if (method == "mean_value") EXPECT_GT(stated, 0.05);
      else EXPECT_LT(stated, 1e-14);
      EXPECT_LE(moved, measured(panel, "largest displacement over cage size") + 1e-14);
      EXPECT_NEAR(measured(panel, "volume ratio"),
                  volume(panel.data.vertices, panel.data.faces) / volume(rest, panel.data.faces), 0.01);
    }
  }
}

TEST(PaperFigures, panels_show_their_method_with_their_parameters) {
  const auto figure = pressed_figure();
  const auto found = all_of(*figure);
  ASSERT_TRUE(figure->is_in(found));
  const auto sheets = figure->sheets(found);
  ASSERT_EQ(sheets.size(), 2u);
  const Cage cage = embedded_cage("cube");
  const auto& method = deformation::deform_method_named("somigliana");
  for (const auto& sheet : sheets)
    for (const double nu : {0.0, 0.3, 0.45})
      for (const double gamma : {-2.0, 0.0, 4.0}) {
        const auto& panel = panel_of(sheet, "nu" +
                                                std::string(nu == 0     ? "0"
                                                            : nu == 0.3 ? "0.3"
                                                                        : "0.45") +
                                                ".gamma" + std::to_string(static_cast<int>(gamma)));
        const auto deformer = deformation::prepare_deformer<double>(
            method, cage, {.parameters = {sheet.name == "c23-local" ? 1.0 : 0.0, nu, gamma, 0, 0.5}});
        const auto posed = deformer->pose({panel.cage});
        for (const std::size_t p : {std::size_t{0}, std::size_t{100}, panel.data.vertices.size() - 1}) {
          const Vec3<double> at = sheet.panels[0].data.vertices[p];
          const auto image = deformer->images(*posed, std::span(&at, 1), 0).tensors[0];
          for (int c = 0; c < 3; ++c) EXPECT_NEAR(image[c], panel.data.vertices[p][c], 1e-12) << panel.file;
        }
      }
}

// Coordinates are shared by panels of a kind; parameters that decide the coordinates make others.
TEST(PaperFigures, panels_whose_parameters_decide_the_coordinates_have_their_own) {
  const auto cage = std::make_shared<const Cage>(embedded_cage("cube"));
  std::vector<Vec3<double>> posed = cage->vertices();
  posed[7] += Vec3<double>(0.3, 0.2, 0.4);
  DeformedPlan plan{.name = "two", .cage = cage, .mesh = {}, .sheets = {}};
  plan.mesh.mesh.vertices = {{0.1, 0.2, -0.15}, {0.3, -0.35, 0.25}};
  plan.sheets.push_back({.name = "two", .heading = "", .source = "", .text = "", .columns = 2, .panels = {}});
  const std::vector<std::pair<std::string, double>> kinds{{"constant", 0}, {"affine", 1}};
  for (const auto& [neumann, value] : kinds)
    plan.sheets[0].panels.push_back({.title = neumann,
                                     .file = neumann,
                                     .method = "biharmonic_1_3",
                                     .parameters = {{"neumann", neumann}},
                                     .posed = posed});
  const auto figure = deformed_figure(plan);
  const FigureFindings found = all_of(*figure);
  for (const auto& [neumann, value] : kinds) {
    const auto deformer = deformation::prepare_deformer<double>(deformation::deform_method_named("biharmonic_1_3"),
                                                                *cage, {.parameters = {1, 3, 1, 0, value}});
    const auto images =
        deformer->images(*deformer->pose({posed}), std::span(std::as_const(plan.mesh.mesh.vertices)), 0);
    const auto& shown = found.at("figure/two/" + neumann).vertices;
    ASSERT_EQ(shown.size(), 2U);
    for (std::size_t p = 0; p < 2; ++p)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(images.tensors[0][p * 3 + c], shown[p][c], 1e-12) << neumann;
  }
}

TEST(PaperFigures, do_not_depend_on_threads_and_need_all_their_parts) {
  const auto figure = plane_bar_figure();
  FigureFindings one = all_of(*figure, 1);
  const FigureFindings two = all_of(*figure, 2);
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [key, mesh] : one) {
    EXPECT_EQ(key.rfind("figure/", 0), 0u);
    EXPECT_EQ(mesh.vertices, two.at(key).vertices) << key;
  }
  EXPECT_TRUE(figure->is_in(one));
  // Each is needed, the posed cage that a method finds by itself too.
  for (const auto& [key, mesh] : two) {
    one.erase(key);
    EXPECT_FALSE(figure->is_in(one)) << key;
    one[key] = mesh;
  }
  EXPECT_TRUE(sheets_of_run({}).empty());
}

TEST(PaperFigures, measured_as_units_of_a_run_are_all_there) {
  reports::Journal journal;
  journal.header.units = 1;
  journal.done = {true};
  journal.gathered = measure_all(figure_measurements(true), 0);
  EXPECT_TRUE(journal.gathered.rows.empty()) << "figures promise nothing";
  // A report is made of the journal as it is read again.
  const fs::path file = fs::temp_directory_path() / ("figures-journal-" + std::to_string(::getpid()));
  std::ofstream(file) << reports::journal_text(journal);
  const PartialResult found = reports::read_journal(file).gathered;
  fs::remove(file);
  std::vector<std::string> names;
  for (const reports::FigureSheet& sheet : sheets_of_run(found.meshes)) names.push_back(sheet.name);
  EXPECT_EQ(names, (std::vector<std::string>{"t24-bend",         "t24-twist",
                                             "c23-global",       "c23-local",
                                             "c23-kernels",      "t18-symmetry",
                                             "quads-kept",       "w12-bar",
                                             "w12-legs",         "w12-same-square",
                                             "w12-rhombus",      "w12-star",
                                             "w12-neck",         "w12-seam",
                                             "c23-star",         "c23-infinite-ratio",
                                             "c23-bar",          "c23-infinite-ratio-bar",
                                             "c23-hexagon",      "c23-l",
                                             "t24-gamma",        "t24-alignment",
                                             "t24-variational",  "t24-spikes",
                                             "t18-valid-quads",  "t18-projection",
                                             "t18-tessellation", "t18-norm-correction",
                                             "t18-twisted-box",  "t18-spherical",
                                             "t18-triquad",      "t18-positive"}));
  const auto before = sheets_of_run(journal.gathered.meshes);
  std::size_t number = 0;
  for (const reports::FigureSheet& sheet : sheets_of_run(found.meshes)) {
    EXPECT_EQ(reports::figure_png(sheet), reports::figure_png(before[number++])) << sheet.name;
    std::set<std::string> files;
    for (const reports::FigurePanel& panel : sheet.panels) EXPECT_TRUE(files.insert(panel.file).second) << panel.file;
    for (const reports::FigureFrame& frame : reports::layout_of(sheet).frames)
      EXPECT_GT(frame.share, 0.5) << sheet.name;
  }
}

TEST(PaperFigures, bars_of_the_plane_meet_their_polygon_where_coordinates_interpolate) {
  const auto figure = plane_bar_figure();
  const reports::FigureSheet sheet = figure->sheets(all_of(*figure)).at(0);
  const auto& rest = sheet.panels[0].data.vertices;
  const Cage cage = plane_bar();
  // How far images of the polygon's own vertices are from its posed vertices.
  const auto miss = [&](const reports::FigurePanel& panel) {
    double found = 0;
    for (std::size_t v = 0; v < cage.vertices().size(); ++v)
      for (std::size_t p = 0; p < rest.size(); ++p)
        if (rest[p] == cage.vertices()[v]) found = std::max(found, (panel.data.vertices[p] - panel.cage[v]).norm());
    return found;
  };
  EXPECT_LT(miss(panel_of(sheet, "mean_value")), 1e-12);
  EXPECT_LT(miss(panel_of(sheet, "harmonic")), 0.05) << "boundary elements meet it nearly";
  EXPECT_GT(miss(panel_of(sheet, "green")), 0.01);
  // Points that are held stay on their marks.
  const auto& thickness = panel_of(sheet, "thickness");
  ASSERT_EQ(thickness.marks.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto p = std::ranges::find(rest, sheet.panels[0].marks[k]) - rest.begin();
    EXPECT_LT((thickness.data.vertices[p] - thickness.marks[k]).norm(), 1e-8) << k;
  }
}

TEST(PaperFigures, kernels_are_those_that_quadrature_gives) {
  const auto figure = kernel_figure();
  const auto found = all_of(*figure);
  const reports::FigureSheet sheet = figure->sheets(found).at(0);
  ASSERT_EQ(sheet.panels.size(), 12u);
  const Cage cage =
      Cage::make_polygon("pentagon", sheet.panels[0].cage,
                         {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 4, -1, -1}}, {{4, 0, -1, -1}}});
  const CageCoordinates by_rule(cage, coordinate_kind_named("somigliana"),
                                CoordinateOptions{"adaptive", Triangulation::Shortest, {1, 0.3}});
  const auto& vertices = cage.vertices();
  const auto normal = [&](int e) {
    const Vec3<double> along = vertices[(e + 1) % 5] - vertices[e];
    return Vec3<double>(Vec3<double>(along[1], -along[0], 0).normalized());
  };
  const auto& of_k = panel_of(sheet, "Kn.nu0.3");
  const auto& of_t = panel_of(sheet, "Tt.nu0.3");
  const Vec3<double> n = normal(3), m = (normal(0) + normal(1)).normalized();
  double longest = 0;
  for (std::size_t p = 0; p < of_k.data.vertices.size(); p += 20) {
    const auto tables = by_rule.at<double>(std::span(&of_k.data.vertices[p], 1), 0);
    const double* const k = &tables[1].tensors[0][4 * 3];
    const double* const t = &tables[0].tensors[0][4 * 1];
    EXPECT_NEAR(of_k.data.arrays[0].values[3 * p], k[0] * n[0] + k[1] * n[1], 1e-10);
    EXPECT_NEAR(of_k.data.arrays[0].values[3 * p + 1], k[2] * n[0] + k[3] * n[1], 1e-10);
    EXPECT_NEAR(of_t.data.arrays[0].values[3 * p], -t[0] * m[1] + t[1] * m[0], 1e-10);
    EXPECT_NEAR(of_t.data.arrays[0].values[3 * p + 1], -t[2] * m[1] + t[3] * m[0], 1e-10);
  }
  for (const auto& arrow : of_k.arrows) longest = std::max(longest, arrow.strength);
  EXPECT_EQ(longest, 1);
}

TEST(PaperFigures, parameters_that_do_not_exist_are_refused) {
  DeformedPlan plan{.name = "bad",
                    .cage = std::make_shared<const Cage>(embedded_cage("cube")),
                    .mesh = rounded_box({0.3, 0.3, 0.3}, 0.1, 0.1),
                    .sheets = {}};
  plan.sheets = {{.name = "bad",
                  .heading = "",
                  .source = "",
                  .text = "",
                  .columns = 1,
                  .panels = {{.title = "", .file = "x", .method = "green", .parameters = {{"strech", "rms"}}}}}};
  EXPECT_THROW(deformed_figure(plan), InputError);
  plan.sheets[0].panels[0].parameters = {{"stretch", "square"}};
  EXPECT_THROW(deformed_figure(plan), InputError);
}

}  // namespace
}  // namespace cageproof::validation::paper_figures_test
