// SPDX-License-Identifier: MIT
// Kinds that are solved for in the plane, on polygons of several shapes.
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/scheme_errors.h"

#include <gtest/gtest.h>

#include <map>

namespace cageproof::validation {
namespace {

using Corners = std::vector<std::pair<double, double>>;

Cage polygons(const char* name, const std::vector<Corners>& parts) {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> segments;
  for (const Corners& corners : parts) {
    const int first = static_cast<int>(vertices.size()), n = static_cast<int>(corners.size());
    for (int k = 0; k < n; ++k) {
      vertices.emplace_back(corners[k].first, corners[k].second, 0);
      segments.push_back({{first + k, first + (k + 1) % n, -1, -1}});
    }
  }
  return Cage::make_polygon(name, vertices, segments, {});
}

std::vector<Cage> shapes() {
  return {polygons("L", {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}),
          polygons("thin bar", {{{0, 0}, {1, 0}, {1, 0.015625}, {0, 0.015625}}}),
          polygons("ring", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}),
          polygons("far away", {{{1e6, 3e6}, {1e6 + 2, 3e6}, {1e6 + 2.5, 3e6 + 1.25}, {1e6 + 1, 3e6 + 2}}})};
}

std::vector<ResultRow> rows_of(const Cage& cage, const std::string& kind, const std::string& evaluation = "") {
  CageCampaignOptions options;
  options.kinds = kind;
  options.evaluation = evaluation;
  options.points = 60;
  options.truth_points = 4;
  return run_cage_campaign(cage, options);
}

TEST(solved_kinds, keep_their_promises) {
  for (const Cage& cage : shapes())
    for (const char* kind : {"biharmonic_boundary", "triharmonic_boundary", "harmonic", "cauchy"}) {
      const auto rows = rows_of(cage, kind);
      EXPECT_GT(rows.size(), 15u);
      for (const ResultRow& row : rows)
        EXPECT_NE(row.verdict, Verdict::Broken) << cage.name() << ' ' << kind << ' ' << row.check << ' ' << row.place
                                                << ' ' << row.order << ": " << row.max;
    }
}

// The paper's offset breaks linear reproduction, unlike the exact limits; its errors are shown, not judged.
TEST(solved_kinds, show_what_the_offset_costs) {
  bool found = false;
  for (const ResultRow& row : rows_of(shapes()[0], "biharmonic_boundary", "offset-1e-6"))
    if (row.check == "linear_reproduction" && row.place == "inside" && row.order == 0) {
      found = true;
      EXPECT_EQ(row.verdict, Verdict::NotPromised);
      EXPECT_GT(row.max, 1e4);
    }
  EXPECT_TRUE(found);
}

std::map<std::pair<std::string, int>, double> scheme_figures(const std::string& kind) {
  std::map<std::pair<std::string, int>, double> figures;
  for (const ResultRow& row : rows_of(embedded_cage("square"), kind))
    if (row.check == "scheme_error" || row.check == "boundary_data") {
      EXPECT_EQ(row.verdict, Verdict::NotPromised) << row.check;
      figures[{row.check, row.order}] = std::max(figures[{row.check, row.order}], row.max);
    }
  return figures;
}

// The audit's figures for four pieces: some percent of the true coordinates, more next to the cage.
TEST(solved_kinds, show_how_far_their_schemes_are_from_what_they_approximate) {
  const auto biharmonic = scheme_figures("biharmonic_boundary");
  EXPECT_GT(biharmonic.at({"scheme_error", 0}), 5e-3);
  EXPECT_LT(biharmonic.at({"scheme_error", 0}), 5e-2);
  EXPECT_GT(biharmonic.at({"boundary_data", 0}), 1e-3);
  EXPECT_LT(biharmonic.at({"boundary_data", 0}), 5e-2);
  EXPECT_GT(biharmonic.at({"boundary_data", 1}), 0.05);
  EXPECT_LT(biharmonic.at({"boundary_data", 1}), 2);
  // Harmonic functions of hat functions are bilinear in the square, and have no normal derivatives as data.
  const auto harmonic = scheme_figures("harmonic");
  EXPECT_LT(harmonic.at({"scheme_error", 0}), 1e-2);
  EXPECT_FALSE(harmonic.contains({"boundary_data", 1}));
  EXPECT_TRUE(scheme_figures("cauchy").empty());
}

// Against functions that do not come from the kind that the scheme is measured with: x y and the like.
TEST(solved_kinds, scheme_errors_are_differences_from_bilinear_functions_in_the_square) {
  const Cage square = embedded_cage("square");
  const CageCoordinates coordinates(square, coordinate_kind_named("harmonic"), CoordinateOptions{});
  const auto truth = approximated_by(square, coordinates.kind(), Triangulation::Shortest);
  ASSERT_TRUE(truth);
  const Vec3<double> low = square.vertices()[0], high = square.vertices()[2], point = low + 0.3 * (high - low);
  const auto errors = scheme_errors_at(coordinates, *truth, square, point, 0);
  double worst = 0;
  const auto found = coordinates.at<double>(point, 0)[0].value;
  const std::array<double, 4> bilinear{0.49, 0.21, 0.09, 0.21};
  for (int i = 0; i < 4; ++i) worst = std::max(worst, std::abs(found[i] - bilinear[i]));
  EXPECT_GT(worst, 1e-6);
  EXPECT_NEAR(errors[0], worst, 1e-9);
  EXPECT_FALSE(approximated_by(square, coordinate_kind_named("cauchy"), Triangulation::Shortest));
}

TEST(solved_kinds, boundary_data_are_hat_functions_and_slopes_of_edges) {
  const Cage square = embedded_cage("square");
  const CageCoordinates green(square, coordinate_kind_named("green"), CoordinateOptions{});
  const Vec3<double> middle = (square.vertices()[0] + square.vertices()[1]) / 2;
  const auto missed = boundary_data_errors_at(green, square, middle);
  ASSERT_TRUE(missed);
  // Green coordinates do not interpolate: of the hat functions half is there, and of the normal derivative.
  EXPECT_NEAR(*(*missed)[0], 0.25, 0.1);
  EXPECT_NEAR(*(*missed)[1], 0.5, 0.3);
  EXPECT_FALSE(boundary_data_errors_at(green, square, Vec3<double>(0.3, 0.4, 0)));
  const auto corner = boundary_data_errors_at(green, square, square.vertices()[0]);
  ASSERT_TRUE(corner);
  EXPECT_FALSE((*corner)[1]);
}

}  // namespace
}  // namespace cageproof::validation
