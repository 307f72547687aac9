// SPDX-License-Identifier: MIT
#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_errors.h"
#include "cages/inside_limit.h"
#include "cages/cage_symmetries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation::cage_campaign_test {
namespace {

// Runs judge many points; these are for every path of the code, sanitized too.
CageCampaignOptions few_points() {
  CageCampaignOptions options;
  options.points = 30;
  options.truth_points = 2;
  return options;
}

void expect_kept(const Cage& cage, const CageCampaignOptions& options) {
  const auto rows = run_cage_campaign(cage, options);
  EXPECT_FALSE(rows.empty());
  for (const ResultRow& row : rows)
    EXPECT_NE(row.verdict, Verdict::Broken) << cage.name() << ' ' << row.subject << ' ' << row.check << ' ' << row.place
                                            << " order " << row.order << ": " << row.max;
}

// A kind that refused a valid cage would drop its rows, and break nothing.
TEST(coordinates, of_every_kind_exist_on_every_embedded_surface) {
  std::vector<std::string_view> names = embedded_cage_names();
  const std::size_t ordinary = names.size();
  for (const auto name : extreme_cage_names()) names.push_back(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view name = names[i];
    const bool extreme = i >= ordinary;
    const Cage cage = embedded_cage(name);
    if (cage.dimension() != 3) continue;
    CageCampaignOptions options;
    options.solved_elements = extreme ? 0 : 50;
    for (const CoordinateKind& kind : coordinate_kinds()) {
      // Kinds of the plane, and those that solve on samples, which want walls of some thickness.
      if (!exists_on(kind, cage) || !is_affordable(kind, cage, options)) continue;
      EXPECT_TRUE(accepts(kind, cage)) << name << ' ' << kind.name;
      // Its walls are too thin for the pieces of their faces.
      if (name == "thin-box" && (kind.name == "harmonic" || kind.name == "elastic"))
        EXPECT_THROW(CageCoordinates(cage, kind, {}), InputError) << kind.name;
      else EXPECT_NO_THROW(CageCoordinates(cage, kind, {})) << name << ' ' << kind.name;
    }
  }
}

// However few points meet the truth, one of them is inside, where cages are used.
TEST(cage_properties, meet_the_truth_inside) {
  CageCampaignOptions options;
  options.points = 16;
  options.truth_points = 1;
  options.kinds = "green";
  int seeds = 0;
  for (options.seed = 1; options.seed <= 4; ++options.seed) {
    std::uint64_t inside = 0, compared = 0;
    for (const ResultRow& row : run_cage_campaign(embedded_cage("thin-box"), options)) {
      if (row.place != "inside" || row.order != 0) continue;
      if (row.check == "partition_of_unity") inside += row.samples;
      if (row.check == "cage_truth") compared += row.samples;
    }
    if (inside == 0) continue;
    EXPECT_GT(compared, 0U) << options.seed;
    ++seeds;
  }
  EXPECT_GE(seeds, 3);
}

// Rows stand under the scalar that they are computed in: differences of double would not see 1e-30.
// Costly evaluations are asked at as few points as leave a verdict for each place.
TEST(cage_properties, of_one_point_per_place_have_all_rows) {
  const Cage cage = embedded_cage("cube");
  CageCampaignOptions options = few_points();
  options.kinds = "mean_value";
  options.properties_alone = true;
  const auto all = run_cage_campaign(cage, options);
  options.one_per_place = true;
  const auto few = run_cage_campaign(cage, options);
  ASSERT_EQ(few.size(), all.size());
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].check, all[i].check);
    EXPECT_EQ(few[i].place, all[i].place);
    EXPECT_EQ(few[i].verdict, all[i].verdict);
    EXPECT_EQ(few[i].samples, 1U);
    EXPECT_GT(all[i].samples, 1U);
  }
}

TEST(cage_properties, name_the_scalar_of_differences) {
  CageCampaignOptions options = few_points();
  options.kinds = "green";
  std::size_t differences = 0;
  for (const ResultRow& row : run_cage_campaign(embedded_cage("square"), options)) {
    EXPECT_EQ(row.scalar == "mp100", row.check == "cage_differences") << row.check << ' ' << row.scalar;
    if (row.check != "cage_differences") continue;
    ++differences;
    EXPECT_EQ(row.verdict, Verdict::Kept) << row.place << ' ' << row.order;
  }
  EXPECT_GT(differences, 0u);
}

// Only the kinds whose elements take least time are asked: slivers need hundreds of digits.
TEST(cage_properties, hold_with_derivatives_on_extreme_cages) {
  CageCampaignOptions options = few_points();
  options.points = 12;
  options.truth_points = 1;
  options.on_points = 8;
  options.differences = false;
  for (const char* kind : {"mean_value", "green"}) {
    options.kinds = kind;
    for (const char* name : {"thin-wall-1e-9", "wedge-1e-6", "crack-1e-6", "hollow-1e-9", "gap-1e-9", "nested"})
      expect_kept(embedded_cage(name), options);
  }
}

TEST(shared_data, cage_properties_hold_on_real_cages) {
  const std::filesystem::path folder = CAGEPROOF_SHARED_DATA;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the data are not next to the project";
  for (const auto* name : {"FireHydrant", "SpikyBox", "WireSphere", "Bench"})
    expect_kept(read_cage(folder / (std::string(name) + "_Cage.obj")), few_points());
}

// Mean value coordinates are affine there: a Hessian that is zero, and a second difference of nothing but rounding.
TEST(cage_properties, hold_on_tetrahedra) {
  const std::vector<Face> faces{{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}};
  expect_kept(Cage::make("corner", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, faces), few_points());
  expect_kept(Cage::make("regular", {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}, faces, {.flip_inward = true}),
              few_points());
}

TEST(cage_properties, fail_for_a_coarse_quadrature) {
  CageCampaignOptions options = few_points();
  options.evaluation = "gauss-4";
  options.kinds = "green";
  double worst = 0;
  for (const ResultRow& row : run_cage_campaign(embedded_cage("cube"), options))
    if (row.check == "partition_of_unity" && row.order == 0) worst = std::max(worst, row.max_relative);
  EXPECT_GT(worst, 1e-3);
}

// Roundings below zero of a kind's least coordinate inside; nothing where that is not asked.
std::optional<double> roundings_below_zero(const char* cage, const char* kind, bool signs = true) {
  CageCampaignOptions options = few_points();
  options.kinds = kind;
  options.signs = signs;
  for (const ResultRow& row : run_cage_campaign(embedded_cage(cage), options)) {
    if (row.check != "non_negativity") continue;
    EXPECT_EQ(row.place, "inside") << "outside they sum to zero, or may be negative in any cage";
    EXPECT_EQ(row.verdict, Verdict::NotPromised);
    EXPECT_GT(row.samples, 0);
    return row.max;
  }
  return std::nullopt;
}

TEST(cage_signs, are_those_that_kinds_are_known_for) {
  EXPECT_LT(roundings_below_zero("cube", "mean_value"), 64.) << "positive in convex cages";
  EXPECT_GT(roundings_below_zero("star", "mean_value"), 1e6) << "negative next to reentrant corners";
  EXPECT_EQ(roundings_below_zero("l-block", "maximum_entropy"), 0.) << "exponentials";
  EXPECT_EQ(roundings_below_zero("cube", "positive_mean_value"), 0.) << "integrals of what is not negative";
  EXPECT_EQ(roundings_below_zero("cube", "somigliana"), std::nullopt) << "matrices";
  EXPECT_EQ(roundings_below_zero("cube", "mean_value", false), std::nullopt);
}

TEST(positive_mean_value, keeps_its_promises_where_faces_hide_others) {
  CageCampaignOptions options = few_points();
  options.kinds = "positive_mean_value";
  options.solved_elements = 50;
  for (const char* name : {"l-block", "twisted-bar", "hollow-1e-3", "crack-1e-12", "pinch-1e-5"})
    expect_kept(embedded_cage(name), options);
}

// The closed form plus a term without symmetry, whose derivatives are not its derivatives.
const RegisterEvaluation broken{
    single_family("triangle.single_layer", "broken", {.description = "broken on purpose", .role = Role::Foreign}, false,
                  [](Evaluation& bad) {
                    const Evaluation good = evaluation_named("triangle.single_layer", "closed_form");
                    for (const ScalarKind kind : scalar_kinds)
                      with_scalar(kind, [&]<Scalar R>() {
                        bad.set_point<R>([good](const Query<R>& query, Result<R>& result) {
                          good(query, result);
                          const R term = (query.point[0] + 2 * query.corners[0][1] + 1) / 1000000;
                          for (int o = 0; o <= query.order; ++o)
                            for (R& x : result.of(o)) x += term;
                        });
                      });
                  })};

TEST(cage_symmetries, fail_for_a_broken_evaluation) {
  static const CoordinateKind kind{
      .name = "psi alone", .source = "", .blocks = {{"psi", "single_layer", Reproduces::Normals}}};
  const Vec3<double> point(0.11, -0.07, 0.05);
  for (const std::string evaluation : {"closed_form", "broken"}) {
    const CageSymmetries symmetries(embedded_cage("cube"), kind, evaluation, Triangulation::Shortest);
    const bool bad = evaluation == "broken";
    const auto errors = symmetries.errors_at(point);
    EXPECT_EQ(errors.size(), 4u);
    for (const auto& [check, error] : errors) EXPECT_EQ(error.relative > 1e-12, bad) << check << ' ' << error.relative;
    const auto differences = symmetries.differences_at(point);
    for (int o = 1; o <= 2; ++o) EXPECT_EQ(differences[o] > 1e-30, bad) << o;
  }
}

TEST(limit_from_inside, fails_for_a_coarse_quadrature) {
  const Cage cube = embedded_cage("cube");
  const CageLocator locator(cube, Triangulation::Shortest);
  for (const auto* evaluation : {"closed_form", "gauss-4"}) {
    const CageCoordinates green(cube, *find_coordinate_kind("green"), evaluation, Triangulation::Shortest);
    const bool coarse = std::string(evaluation) == "gauss-4";
    const double error = inside_limit_errors_at(green, cube, locator, cube.vertices()[0], 0)[0].value();
    EXPECT_EQ(error > 1e-6, coarse) << error;
    // Within a face, off its diagonals.
    const auto& corners = cube.faces()[0].vertices;
    const Vec3<double> on = .5 * cube.vertices()[corners[0]] + .125 * cube.vertices()[corners[1]] +
                            .25 * cube.vertices()[corners[2]] + .125 * cube.vertices()[corners[3]];
    const auto errors = inside_limit_errors_at(green, cube, locator, on, 2);
    EXPECT_EQ(errors[0].value() > 1e-6, coarse) << errors[0].value();
    for (int o = 1; o <= 2; ++o) EXPECT_EQ(errors[o].value() > 1e-10, coarse) << o << ' ' << errors[o].value();
  }
}

TEST(locator, agrees_with_the_cube) {
  const Cage cube = embedded_cage("cube");
  const CageLocator locator(cube, Triangulation::Shortest);
  Vec3<double> low = cube.vertices()[0], high = low;
  for (const auto& v : cube.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  for (const CagePoint& p : points_off(cube, locator, 9, 500)) {
    const bool within = (p.point - low).minCoeff() > 0 && (high - p.point).minCoeff() > 0;
    if (p.place != Place::TooClose) {
      EXPECT_EQ(p.place == Place::Inside, within);
    }
  }
  EXPECT_NEAR(locator.distance(Vec3<double>(high + Vec3<double>(3, 0, 4))), 5, 1e-12);
}

// 4 pi inside, 0 outside, of bilinear quads cut into 2 m^2 triangles.
double solid_angle_of_quads(const Cage& cage, const Vec3<double>& eta, int m) {
  double sum = 0;
  const auto add = [&](const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r) {
    const Vec3<double> a = (p - eta).normalized(), b = (q - eta).normalized(), c = (r - eta).normalized();
    sum += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  };
  for (std::size_t f = 0; f < cage.faces().size(); ++f) {
    const auto q = cage.quad(f);
    const auto at = [&](int i, int j) {
      const double u = static_cast<double>(i) / m, v = static_cast<double>(j) / m;
      return Vec3<double>((1 - v) * ((1 - u) * q[0] + u * q[1]) + v * ((1 - u) * q[3] + u * q[2]));
    };
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return sum;
}

TEST(locator, agrees_with_the_solid_angle_of_bent_quads) {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec3<double>> corners = cube.vertices();
  // Every face a saddle.
  for (auto& v : corners)
    if (v.prod() > 0) v *= 0.45;
  for (const Cage& cage : {embedded_cage("twisted-bar"), Cage::make("saddles", corners, cube.faces())}) {
    const CageLocator locator(cage, Triangulation::Shortest, true);
    int inside = 0, asked = 0;
    for (const CagePoint& p : points_off(cage, locator, 9, 600)) {
      if (p.place == Place::TooClose || locator.distance(p.point) < 0.02 * cage.size()) continue;
      const double turns = solid_angle_of_quads(cage, p.point, 24) / (4 * std::acos(-1.0));
      ASSERT_NEAR(turns, std::round(turns), 1e-9);
      EXPECT_EQ(p.place == Place::Inside, std::round(turns) == 1) << cage.name() << ": " << p.point.transpose();
      inside += p.place == Place::Inside;
      ++asked;
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(asked - inside, 20);
  }
}

// Sides have no length, or faces no area, so that every ray grazes one.
TEST(locator, answers_in_cages_with_coinciding_corners) {
  const Cage box = embedded_cage("cube");
  const auto& vertices = box.vertices();
  const auto with = [&](std::initializer_list<std::pair<int, int>> moved) {
    std::vector<Vec3<double>> corners = vertices;
    for (const auto& [from, to] : moved) corners[from] = vertices[to];
    return Cage::make("pinched", corners, box.faces(), {.allow_invalid_quads = true});
  };
  const Face& face = box.faces()[0];
  const auto [a, b, c, d] = face.vertices;
  for (const Cage& cage : {with({{a, b}}), with({{b, c}}), with({{c, d}}), with({{d, a}}), with({{a, b}, {d, c}}),
                           with({{a, b}, {d, b}}), with({{a, c}}), with({{b, d}})}) {
    const CageLocator locator(cage, Triangulation::Shortest, true);
    int inside = 0, asked = 0;
    for (const CagePoint& p : points_off(cage, locator, 3, 200)) {
      if (p.place == Place::TooClose || locator.distance(p.point) < 0.03 * cage.size()) continue;
      const double turns = solid_angle_of_quads(cage, p.point, 24) / (4 * std::acos(-1.0));
      EXPECT_EQ(p.place == Place::Inside, std::round(turns) == 1) << p.point.transpose();
      inside += p.place == Place::Inside;
      ++asked;
    }
    EXPECT_GT(inside, 5);
    EXPECT_GT(asked - inside, 20);
  }
}

TEST(points_off, are_those_of_a_files_content_whatever_its_name) {
  const Cage cube = embedded_cage("cube");
  std::vector<std::vector<Vec3<double>>> drawn;
  for (const char* name : {"a.obj", "folder/b.obj"}) {
    const Cage cage = Cage::make(name, cube.vertices(), cube.faces());
    auto& points = drawn.emplace_back();
    for (const CagePoint& p : points_off(cage, CageLocator(cage, Triangulation::Shortest), 1, 20))
      points.push_back(p.point);
  }
  EXPECT_EQ(drawn[0], drawn[1]);
}

TEST(coordinates, green_derivatives_agree_with_differences) {
  const Cage cage = embedded_cage("l-block");
  const CageCoordinates green(cage, *find_coordinate_kind("green"), "closed_form", Triangulation::Shortest);
  const CageLocator locator(cage, Triangulation::Shortest);
  for (const CagePoint& p : points_off(cage, locator, 4, 6)) {
    if (locator.distance(p.point) < 0.05) continue;
    const auto at = green.at<double>(p.point, 2);
    constexpr double h = 1e-5;
    for (int a = 0; a < 3; ++a) {
      Vec3<double> plus = p.point, minus = p.point;
      plus[a] += h;
      minus[a] -= h;
      const auto up = green.at<double>(plus, 1), down = green.at<double>(minus, 1);
      for (std::size_t b = 0; b < at.size(); ++b)
        for (std::size_t i = 0; i < at[b].value.size(); ++i) {
          EXPECT_NEAR((up[b].value[i] - down[b].value[i]) / (2 * h), at[b].gradient[3 * i + a], 1e-6);
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR((up[b].gradient[3 * i + c] - down[b].gradient[3 * i + c]) / (2 * h),
                        at[b].hessian[9 * i + 3 * c + a], 1e-4);
        }
    }
  }
}

TEST(coordinates, mean_value_derivatives_agree_with_differences) {
  const Cage cage = embedded_cage("cube");
  const CageCoordinates lambda(cage, *find_coordinate_kind("mean_value"), "closed_form", Triangulation::Shortest);
  const Vec3<double> centre = Vec3<double>(0.11, -0.07, 0.05);
  const auto at = lambda.at<double>(centre, 2)[0];
  constexpr double h = 1e-5;
  for (int a = 0; a < 3; ++a) {
    Vec3<double> plus = centre, minus = centre;
    plus[a] += h;
    minus[a] -= h;
    const auto up = lambda.at<double>(plus, 1)[0], down = lambda.at<double>(minus, 1)[0];
    for (std::size_t i = 0; i < at.value.size(); ++i) {
      EXPECT_NEAR((up.value[i] - down.value[i]) / (2 * h), at.gradient[3 * i + a], 1e-7);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR((up.gradient[3 * i + c] - down.gradient[3 * i + c]) / (2 * h), at.hessian[9 * i + 3 * c + a], 1e-5);
    }
  }
}

// The midpoints of these edges are not doubles, and where a face is a thousand times as wide as the cage is thick,
// layers of rounded ones differ by 790 roundings: layers of another cage.
TEST(cage, subdivided_at_midpoints_that_are_doubles) {
  const std::vector<Vec3<double>> vertices{{1.3, .7, -.2},  {-.7, .7, -.2}, {.3, .701, -.2},
                                           {.3, .699, -.2}, {.3, .7, .8},   {.3, .7, -1.2}};
  std::vector<Face> faces;
  for (const auto& [a, b, c] :
       {std::array{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
    faces.push_back({{a, b, c, -1}});
  const Cage cage = Cage::make("flat octahedron", vertices, faces);
  const Vec3<double> point(0x1.c56bdb38bc0bfp-1, 0x1.668453920bdcfp-1, -0x1.886e85ac6c5a4p-2);
  for (const char* kind : {"mean_value", "green", "biharmonic"}) {
    const CageSymmetries symmetries(cage, coordinate_kind_named(kind), "hybrid", Triangulation::Shortest);
    const CageError error = symmetries.errors_at(point).at("cage_subdivision");
    EXPECT_LE(error.roundings, 64) << kind;
  }
}

}  // namespace
}  // namespace cageproof::validation::cage_campaign_test
