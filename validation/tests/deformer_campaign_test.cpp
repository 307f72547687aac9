// SPDX-License-Identifier: MIT
// Deformers keep some maps and must miss others: one that keeps them is another method ([T24], [C23], Lipman et al.).
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "deformers/constrained_checks.h"
#include "deformers/deformer_campaign.h"
#include "deformers/rounded_pose.h"
#include "cageproof/validation/replay.h"
#include "promises/verdicts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cageproof::validation {
namespace {

// Rows of the methods that a glob names; each test asks only for those it looks at.
const std::vector<ResultRow>& rows_on(const std::string& cage, const std::string& methods = "*") {
  static std::map<std::pair<std::string, std::string>, std::vector<ResultRow>> known;
  const auto [at, fresh] = known.try_emplace({cage, methods});
  if (fresh) at->second = run_deformer_campaign(embedded_cage(cage), {.methods = methods});
  return at->second;
}

std::vector<ResultRow> rows_of_check(const std::string& cage, std::string_view check, std::string_view subject,
                                     std::string_view variant = "") {
  std::vector<ResultRow> found;
  for (const ResultRow& row : rows_on(cage, std::string(subject)))
    if (row.check == check && row.subject == subject && (variant.empty() || row.evaluation == variant))
      found.push_back(row);
  return found;
}

TEST(deformers, of_all_methods_are_asked_what_they_keep) {
  for (const std::string_view name : {"cube", "square", "l-shape"}) {
    const Cage cage = embedded_cage(name);
    for (const deformation::DeformMethod& method : deformation::deform_methods()) {
      if (!deformation::why_refused(method, cage).empty()) continue;
      for (const DeformerVariant& variant : variants_of(method))
        for (const char* check : {"keeps_rigid", "keeps_scale", "keeps_mirror", "keeps_linear"}) {
          const auto rows = rows_of_check(std::string(name), check, method.name, variant.name);
          EXPECT_EQ(rows.size(), std::string_view(check) == "keeps_rigid" ? 3 : 1)
              << name << ' ' << method.name << ' ' << variant.name << ' ' << check;
          for (const ResultRow& row : rows) EXPECT_EQ(row.asked, 12U);
        }
    }
  }
}

TEST(deformers, of_all_methods_are_asked_far_from_the_origin) {
  for (const std::string_view name : {"cube", "square"}) {
    const Cage cage = embedded_cage(name);
    const auto expect_kept = [&](std::string_view method, std::size_t variants) {
      const auto rows = rows_of_check(std::string(name), "keeps_offset", method);
      EXPECT_EQ(rows.size(), 2 * variants) << name << ' ' << method;
      for (const ResultRow& row : rows)
        EXPECT_EQ(row.verdict, Verdict::Kept) << name << ' ' << method << ' ' << row.place << ' ' << row.max;
    };
    for (const deformation::DeformMethod& method : deformation::deform_methods())
      if (deformation::why_refused(method, cage).empty()) expect_kept(method.name, 1);
    for (const deformation::ConstraintMethod& method : deformation::constraint_methods())
      if (can_be_asked(method, cage, Triangulation::Shortest)) expect_kept(method.name, variants_of(method).size());
  }
}

// Where nothing is asked, nothing is kept: each of these has rows, and they are kept.
TEST(deformers, meet_their_truth_their_differences_and_their_integrals) {
  const auto expect_kept = [](const char* cage, const char* check, const char* method, std::size_t orders) {
    std::size_t kept = 0;
    for (const ResultRow& row : rows_of_check(cage, check, method))
      if (row.bound) {
        EXPECT_EQ(row.verdict, Verdict::Kept) << cage << ' ' << method << ' ' << check << ": " << row.max;
        ++kept;
      }
    EXPECT_GE(kept, orders) << cage << ' ' << method << ' ' << check;
  };
  for (const char* cage : {"cube", "square", "l-shape"}) {
    for (const char* method : {"green", "somigliana", "mean_value", "biharmonic_1_3", "biharmonic_1_2",
                               "biharmonic_weber", "ahap", "aaap", "tp"}) {
      expect_kept(cage, "deformer_truth", method, 3);
      expect_kept(cage, "deformer_jacobian", method, 2);
    }
    for (const char* method : {"green", "somigliana", "mean_value", "biharmonic_1_3", "biharmonic_weber"})
      expect_kept(cage, "deformer_by_quadrature", method, 1);
  }
  for (const char* cage : {"square", "l-shape"})
    for (const char* method : {"cauchy", "biharmonic_boundary"}) {
      expect_kept(cage, "deformer_truth", method, 3);
      expect_kept(cage, "deformer_jacobian", method, 2);
    }
}

// Checks the errors of a deformer at the reference points of the specification (Section 10), on the cages whose
// figures it gives. Those are the extremes over five cages, so each cage is held to half of the least and twice the
// largest.
void expect_missed(const char* check, const char* method, const char* variant, double least, double most) {
  const std::vector<Vec3<double>> in_cube{{.1, .2, -.15}, {.3, -.35, .25}, {-.45, .4, .1}},
      in_bar{{.1, -.2, .3}, {-.3, .25, -.8}, {.05, .1, .95}};
  for (const char* name : {"cube", "twisted-bar"}) {
    const auto cage = std::make_shared<const Cage>(embedded_cage(name));
    const DeformerChecks checks(cage, variant_named(deformation::deform_method_named(method), variant),
                                Triangulation::Shortest);
    const auto questions = checks.questions();
    const auto question = std::ranges::find(questions, check, [](const auto& q) { return q.key.check; });
    ASSERT_NE(question, questions.end()) << check;
    double worst = 0;
    for (const Vec3<double>& point : cage->name() == "cube" ? in_cube : in_bar)
      worst = std::max(worst, question->ask({point})[0].relative);
    EXPECT_GT(worst, least / 2) << name << ' ' << method << ' ' << variant;
    EXPECT_LT(worst, most * 2) << name << ' ' << method << ' ' << variant;
  }
  EXPECT_EQ(rows_of_check("cube", check, method, variant).at(0).verdict, Verdict::NotPromised);
}

TEST(deformers, with_unit_normals_lose_scale) {
  expect_missed("keeps_scale", "green", "stretch=unit", 2e-2, 4e-2);
  for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"})
    expect_missed("keeps_scale", method, "normals=unit", 1e-2, 2e-2);
}

TEST(deformers, with_posed_normals_lose_mirror_images) {
  for (const char* variant : {"stretch=rms", "stretch=mean", "stretch=area", "stretch=unit"})
    expect_missed("keeps_mirror", "green", variant, 9e-2, 2e-1);
  for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"})
    expect_missed("keeps_mirror", method, "normals=unit", 4e-2, 8e-2);
  for (const char* variant : {"variant=global", "variant=local"})
    expect_missed("keeps_mirror", "somigliana", variant, 7e-2, 7e-1);
}

TEST(deformers, with_posed_normals_lose_linear_maps) {
  for (const char* variant : {"stretch=rms", "stretch=mean", "stretch=area"})
    expect_missed("keeps_linear", "green", variant, 3e-2, 6e-2);
  expect_missed("keeps_linear", "green", "stretch=unit", 3e-2, 5e-2);
  for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"}) {
    expect_missed("keeps_linear", method, "normals=unit", 1e-2, 3e-2);
    expect_missed("keeps_linear", method, "normals=rms", 1e-2, 4e-2);
  }
  for (const char* method : {"ahap", "aaap", "tp"}) expect_missed("keeps_linear", method, "alignment=hard", 5e-3, 3e-2);
  for (const char* variant : {"variant=global", "variant=local"})
    expect_missed("keeps_linear", "somigliana", variant, 2e-2, 2e-1);
}

// [T18] Section 5: what keeps quads keeps their symmetry, and what splits them loses it by parts of the size.
TEST(deformers, that_keep_quads_keep_symmetric_poses_symmetric) {
  for (const char* method : {"quad_mean_value", "quad_green", "quad_biharmonic_1_3", "quad_somigliana",
                             "spherical_mean_value", "maximum_entropy"}) {
    const auto rows = rows_of_check("cube", "keeps_symmetry", method);
    EXPECT_EQ(rows.size(), 3 * variants_of(deformation::deform_method_named(method)).size()) << method;
    for (const ResultRow& row : rows) EXPECT_EQ(row.verdict, Verdict::Kept) << method << ' ' << row.max;
    EXPECT_TRUE(rows_of_check("cube", "keeps_symmetry_of_quads", method).empty()) << method;
  }
  for (const char* method : {"mean_value", "green", "somigliana"}) {
    const auto rows = rows_of_check("cube", "keeps_symmetry_of_quads", method);
    EXPECT_FALSE(rows.empty()) << method;
    for (const ResultRow& row : rows) {
      EXPECT_EQ(row.verdict, Verdict::NotPromised) << method;
      EXPECT_GT(row.max, 1e-3) << method;
      EXPECT_LT(row.max, 1e-1) << method;
    }
  }
  for (const char* method : {"mean_value", "green", "cauchy", "biharmonic_boundary", "tp"}) {
    const auto rows = rows_of_check("square", "keeps_symmetry", method);
    EXPECT_FALSE(rows.empty()) << method;
    for (const ResultRow& row : rows) EXPECT_EQ(row.verdict, Verdict::Kept) << method << ' ' << row.max;
  }
  // An L is no mirror image of itself across an axis.
  EXPECT_TRUE(rows_of_check("l-shape", "keeps_symmetry", "green").empty());
}

TEST(deformers, keep_linear_maps_of_cages_whose_normals_are_given) {
  for (const char* method : {"green", "biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"}) {
    const auto rows = rows_of_check("cube", "keeps_linear_with_normals", method);
    // Stretches, and affine normal derivatives.
    EXPECT_EQ(rows.size(), std::string_view(method) == "green" ? 4U : 5U) << method;
    for (const ResultRow& row : rows) EXPECT_EQ(row.verdict, Verdict::Kept) << method << ' ' << row.max;
  }
}

// [W12] Section 5 after the specification's Section 1: unit normals lose scale by 3e-2 ... 1e-1 of cages of size 1.4 to
// 2.8, all lose mirror images and linear maps, but where these come with their own normal derivatives.
TEST(deformers, of_the_plane_keep_what_the_specification_says) {
  struct Law {
    const char *method, *variant;
    bool scale;
  };
  for (const char* cage : {"square", "l-shape"})
    for (const Law& law :
         {Law{"cauchy", "", true}, Law{"biharmonic_boundary", "normals=unit", false},
          Law{"biharmonic_boundary", "normals=complex", true}, Law{"biharmonic_boundary", "normals=ahap", true}}) {
      const auto expect = [&](const char* check, bool kept) {
        const auto rows = rows_of_check(cage, check, law.method, law.variant);
        ASSERT_FALSE(rows.empty()) << cage << ' ' << law.variant << ' ' << check;
        for (const ResultRow& row : rows) {
          EXPECT_EQ(row.verdict, kept ? Verdict::Kept : Verdict::NotPromised) << cage << ' ' << law.variant << check;
          if (kept) {
            EXPECT_LT(row.max, 1e-13);
          } else {
            EXPECT_GT(row.max, 5e-3) << cage << ' ' << law.variant << ' ' << check;
          }
        }
      };
      expect("keeps_rigid", true);
      expect("keeps_scale", law.scale);
      expect("keeps_mirror", false);
      expect("keeps_linear", false);
      if (std::string_view(law.method) != "cauchy") expect("keeps_linear_with_normals", true);
    }
}

// Methods that take constraints have rows: all subspaces in space and in the plane, thickness in the plane.
TEST(deformers, by_constraints_are_asked_what_they_keep) {
  for (const char* cage : {"cube", "square", "l-shape"})
    for (const char* method : {"variational", "thickness"}) {
      const bool variational = std::string_view(method) == "variational";
      const std::size_t variants = variational ? 3 : std::string_view(cage) == "cube" ? 0 : 1;
      for (const char* check :
           {"energy_falls", "rigid_energy", "energy_is_flat", "constrained_unit", "constrained_motion"}) {
        const auto rows = rows_of_check(cage, check, method);
        std::size_t expected = variants;
        if (!variational && std::string_view(check) == "energy_is_flat") expected = 0;
        // Biharmonic maps of the plane are others in other units.
        if (variational && std::string_view(check) == "constrained_unit" && std::string_view(cage) != "cube")
          expected = 2;
        EXPECT_EQ(rows.size(), expected) << cage << ' ' << method << ' ' << check;
        for (const ResultRow& row : rows) {
          EXPECT_EQ(row.verdict, Verdict::Kept) << cage << ' ' << method << row.evaluation << check << ' ' << row.max;
          EXPECT_EQ(row.asked, std::string_view(check).starts_with("constrained") ? 12U : 1U) << check;
        }
      }
    }
  EXPECT_TRUE(rows_of_check("twisted-bar", "energy_falls", "variational").empty()) << "too many elements";
}

// A drawing of six corners. At the points that its name draws, the map by rotations takes some 700 steps to come to
// rest.
TEST(deformers, by_constraints_keep_a_rigid_motion_of_an_ordinary_drawing) {
  const Cage cage = Cage::make_polygon(
      "p1.svg", {{10, -10, 0}, {10, -170, 0}, {100, -170, 0}, {100, -90, 0}, {170, -80, 0}, {170, -10, 0}},
      {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 4, -1, -1}}, {{4, 5, -1, -1}}, {{5, 0, -1, -1}}},
      {.flip_inward = true});
  for (const char* method : {"variational", "thickness"}) {
    std::size_t asked = 0;
    for (const ResultRow& row : run_deformer_campaign(cage, {.methods = method}))
      if (row.check == "rigid_energy" || row.check == "keeps_offset") {
        ++asked;
        EXPECT_EQ(row.verdict, Verdict::Kept) << method << row.evaluation << row.check << row.place << ' ' << row.max;
      }
    EXPECT_EQ(asked, std::string_view(method) == "variational" ? 9U : 3U);
  }
}

// One position leaves the turns about it free; a triangle has three vertices, and is asked for two. The biharmonic
// layers of the frame have coefficients that change nothing inside: only those of its hole.
TEST(deformers, by_constraints_keep_their_promises_on_a_triangle_and_on_a_polygon_with_a_hole) {
  const Cage triangle = Cage::make_polygon("triangle", {{0, 0, 0}, {1, 0, 0}, {.3, .8, 0}},
                                           {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 0, -1, -1}}}, {});
  for (const Cage& cage : {triangle, embedded_cage("frame")}) {
    std::size_t asked = 0;
    for (const ResultRow& row : run_deformer_campaign(cage, {.methods = "thickness,variational"})) {
      EXPECT_EQ(row.verdict, Verdict::Kept)
          << cage.name() << row.subject << row.evaluation << row.check << row.place << ' ' << row.max;
      asked += row.check == "keeps_offset" ? 1 : 0;
    }
    EXPECT_EQ(asked, 8U) << cage.name();
  }
}

// Coordinates of 1e5 sizes are rounded by 1e-11 of them, and images with them.
TEST(deformers, are_judged_by_the_roundings_of_a_cage_far_from_the_origin) {
  EXPECT_EQ(Excuses{}.factor(), 1);
  EXPECT_EQ((Excuses{.condition = 1e5, .rounding = 2.5e-11}.factor()), 1e5);
  EXPECT_EQ((Excuses{.condition = 1e8, .rounding = 0.1}.factor()), 1e8) << "images without a digit would be kept";
  const Cage cage = embedded_cage("cube");
  EXPECT_LT(rounding_of_coordinates(cage), 2e-16);
  std::vector<Vec3<double>> vertices = cage.vertices();
  for (Vec3<double>& v : vertices) v += Vec3<double>::Constant(1e5);
  const Cage far = cage.with(vertices, cage.faces());
  double largest = 0;
  for (const ResultRow& row : run_deformer_campaign(far, {.methods = "green,aaap,variational"}))
    if (row.verdict != Verdict::NotPromised) {
      EXPECT_EQ(row.verdict, Verdict::Kept)
          << row.subject << row.evaluation << row.check << row.place << ' ' << row.max;
      if (row.check == "keeps_rigid") largest = std::max(largest, row.max_relative);
    }
  EXPECT_GT(largest, 1e-13) << "in sizes they are no better than their coordinates";
}

TEST(deformers, worst_cases_by_constraints_are_found_again) {
  for (const char* method : {"variational", "thickness"})
    for (const char* check : {"energy_falls", "rigid_energy", "constrained_unit", "constrained_motion"})
      for (const ResultRow& row : rows_of_check("square", check, method)) {
        ASSERT_FALSE(row.worst.empty());
        EXPECT_EQ(replay(row, row.worst.front(), Triangulation::Shortest).error, row.max) << method << ' ' << check;
      }
  ResultRow row = rows_of_check("square", "energy_falls", "thickness").at(0);
  row.check = "energy_is_flat";
  EXPECT_THROW(replay(row, row.worst.front(), Triangulation::Shortest), InputError);
}

TEST(deformers, worst_cases_are_found_again) {
  for (const char* check : {"keeps_rigid", "keeps_linear", "deformer_truth", "deformer_jacobian",
                            "deformer_by_quadrature", "keeps_linear_with_normals"})
    for (const ResultRow& row : rows_of_check("cube", check, "biharmonic_1_3", "normals=unit")) {
      ASSERT_FALSE(row.worst.empty());
      const Finding found = replay(row, row.worst.front(), Triangulation::Shortest);
      EXPECT_EQ(found.status, Finding::Status::Measured);
      EXPECT_EQ(found.error, row.max) << check << ' ' << row.place << ' ' << row.order;
    }
}

TEST(deformers, replay_names_what_is_unknown) {
  const ResultRow row = rows_of_check("square", "keeps_scale", "green", "stretch=rms").at(0);
  const auto expect_error = [&](auto change, const char* text) {
    ResultRow other = row;
    change(other);
    try {
      replay(other, row.worst.front(), Triangulation::Shortest);
      ADD_FAILURE() << "no error: " << text;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
    }
  };
  expect_error([](ResultRow& r) { r.subject = "blue"; }, "blue");
  expect_error([](ResultRow& r) { r.evaluation = "stretch=none"; }, "stretch=none");
  expect_error([](ResultRow& r) { r.check = "keeps_secrets"; }, "keeps_secrets");
  expect_error([](ResultRow& r) { r.place = "mirror"; }, "mirror");
  expect_error([](ResultRow& r) { r.order = 1; }, "order 1");
}

TEST(deformers, points_lie_inside_and_depend_on_their_number_alone) {
  const Cage cage = embedded_cage("l-block");
  const CageLocator locator(cage, Triangulation::Shortest);
  const auto points = interior_points(cage, Triangulation::Shortest, 7, 5);
  const auto more = interior_points(cage, Triangulation::Shortest, 7, 9);
  ASSERT_EQ(more.size(), 9U);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], more[i]);
  for (const Vec3<double>& p : more) {
    EXPECT_TRUE(locator.inside(p));
    EXPECT_GE(locator.distance(p), 2e-2 * cage.size());
  }
  EXPECT_NE(interior_points(cage, Triangulation::Shortest, 8, 1).front(), points.front());
}

// Whether few points are found inside, or coordinates do not exist.
TEST(deformers, by_constraints_are_not_judged_in_cages_that_they_refuse) {
  const auto bar = std::make_shared<const Cage>(embedded_cage("thin-bar"));
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods())
    EXPECT_FALSE(can_be_asked(method, *bar, Triangulation::Shortest)) << method.name;
  const Cage cube = embedded_cage("cube"), square = embedded_cage("square");
  const auto& thickness = *deformation::find_constraint_method("thickness");
  EXPECT_FALSE(can_be_asked(thickness, cube, Triangulation::Shortest));
  EXPECT_TRUE(can_be_asked(thickness, square, Triangulation::Shortest));
  EXPECT_TRUE(can_be_asked(*deformation::find_constraint_method("variational"), cube, Triangulation::Shortest));
}

// Nothing is as deep inside a thin bar as points are asked for; a run ends all the same.
// A square with an edge of 1e-9, and so many others that 50 digits would take too long.
TEST(deformers, that_refuse_a_cage_when_they_solve_are_named) {
  constexpr int edges = 140;
  std::vector<Vec3<double>> corners;
  corners.reserve(edges + 4);
  for (int k = 0; k < edges; ++k) corners.emplace_back(static_cast<double>(k) / edges, 0, 0);
  for (const auto& [x, y] : {std::pair{1., 0.}, {1., 1 - 1e-9}, {1 - 1e-9, 1.}, {0., 1.}})
    corners.emplace_back(x, y, 0);
  const int count = static_cast<int>(corners.size());
  std::vector<Face> segments;
  segments.reserve(count);
  for (int k = 0; k < count; ++k) segments.push_back({{k, (k + 1) % count, -1, -1}});
  const auto cage = std::make_shared<const Cage>(Cage::make_polygon("many", corners, segments, {}));
  RefusedMethods refused;
  const Measurements found = deformer_measurements(cage, {.methods = "aaap,green"}, &refused);
  EXPECT_FALSE(found.empty());
  for (const auto& measurement : found) EXPECT_NE(measurement->name().find("green"), std::string::npos);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_NE(refused.begin()->first.find("no digits left of derivatives"), std::string::npos);
  EXPECT_EQ(refused.begin()->second, std::vector<std::string>{"aaap"});
}

TEST(deformers, are_not_judged_in_cages_without_points_deep_enough) {
  const auto bar = std::make_shared<const Cage>(embedded_cage("thin-bar"));
  EXPECT_TRUE(interior_points(*bar, Triangulation::Shortest, 1, 3).empty());
  EXPECT_TRUE(deformer_measurements(bar, {}).empty());
  const auto cube = std::make_shared<const Cage>(embedded_cage("cube"));
  EXPECT_EQ(interior_points(*cube, Triangulation::Shortest, 1, 3).size(), 3U);
}

// A cage at that distance along each axis.
Cage far_cube(double offset) {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec3<double>> moved = cube.vertices();
  for (Vec3<double>& v : moved) v.array() += offset;
  return cube.with(moved, cube.faces());
}

TEST(deformers, that_round_alone_keep_their_promises_far_from_the_origin) {
  for (const double offset : {1e3, 1e6, 1e8, 1e9})
    for (const ResultRow& row : run_deformer_campaign(far_cube(offset), {.methods = "green,mean_value,variational"}))
      EXPECT_NE(row.verdict, Verdict::Broken)
          << offset << ' ' << row.subject << ' ' << row.check << ' ' << row.place << ": " << row.max;
}

TEST(deformers, are_excused_by_conditions_to_seven_digits_and_by_four_roundings_to_five) {
  constexpr double u = 0x1p-53, promised = 1e-13;
  const auto is_kept = [](double plain, const Excuses& excuses) { return excused(plain, excuses).error <= promised; };
  EXPECT_FALSE(is_kept(2e-13, {}));
  EXPECT_TRUE(is_kept(9e-8, {1e8, 1e6 * u}));
  EXPECT_FALSE(is_kept(2e-7, {1e8, 1e6 * u}));
  for (const double sizes : {1e3, 1e6, 1e8, 1e9, 1e10}) {
    EXPECT_TRUE(is_kept(3.9 * sizes * u, {1, sizes * u})) << sizes;
    EXPECT_FALSE(is_kept(4.1 * sizes * u, {1, sizes * u})) << sizes;
  }
  EXPECT_TRUE(is_kept(0.9e-5, {1, 1e12 * u}));
  EXPECT_FALSE(is_kept(1.1e-5, {1, 1e12 * u}));
}

Cage polygon_with_a_short_edge() {
  return Cage::make_polygon("pentagon", {{0, 0, 0}, {1, 0, 0}, {1.3, .8, 0}, {1.3, .800001, 0}, {.6, 1.2, 0}},
                            {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 4, -1, -1}}, {{4, 0, -1, -1}}},
                            {});
}

// The roundings of posed vertices turn an edge that is a millionth of the others by 1e-10, which moves images by 1e-7
// of the size. Bent, the edge is 1e4 times as long, and images lie 1e7 sizes off.
TEST(deformers, keep_their_promises_on_a_polygon_with_a_short_edge) {
  double largest = 0;
  for (const ResultRow& row : run_deformer_campaign(polygon_with_a_short_edge(), {.methods = "aaap"})) {
    EXPECT_NE(row.verdict, Verdict::Broken) << row.evaluation << ' ' << row.check << ' ' << row.place << ' ' << row.max;
    if (row.check == "keeps_rigid") largest = std::max(largest, row.max_relative);
  }
  EXPECT_GT(largest, 1e-9) << "the pose costs nothing here";
}

// Unit normals do not grow with the cage. That is no rounding of the pose, whose vertices are doubles here.
TEST(deformers, are_not_excused_by_roundings_of_poses_where_they_miss_a_map) {
  const Cage cage = polygon_with_a_short_edge();
  const auto& method = deformation::deform_method_named("green");
  const auto deformer = [&] {
    return deformation::prepare_deformer<Mp50>(method, cage,
                                               {.parameters = variant_named(method, "stretch=unit").parameters});
  };
  deformation::Pose<Mp50> doubled{in<Mp50>(cage.vertices())}, nudged = doubled;
  for (auto& v : doubled.vertices) v *= 2;
  EXPECT_EQ(RoundedPose(deformer, doubled, doubled).moves({.7, .6, 0}).norm(), 0);
  nudged = doubled;
  nudged.vertices[2][1] += 0x1p-53;
  const double moved = RoundedPose(deformer, nudged, doubled).moves({.7, .6, 0}).norm();
  EXPECT_GT(moved, 1e-18);
  EXPECT_LT(moved, 1e-14);
}

TEST(deformers, are_judged_by_the_size_of_what_they_give) {
  const std::vector<Mp50> image{Mp50(1003), Mp50(4)};
  EXPECT_EQ(own_size(image, 0, 10., {3, 4, 0}), 100);
  EXPECT_EQ(own_size(image, 0, 1e6, {3, 4, 0}), 1) << "cage sizes are the least unit";
  EXPECT_EQ(own_size(std::vector<double>{0, 30, 40, 0}, 1, 10., {3, 4, 0}), 50);
  EXPECT_EQ(own_size(std::vector<double>{0, 3, 4, 0}, 2, 10., {3, 4, 0}), 50);
}

TEST(deformers, by_maps_that_are_rounded_once) {
  for (const SpaceMap& map : space_maps(3)) {
    const Vec3<double> at(1e9 + .25, 1e9 + .5, 1e9);
    for (int c = 0; c < 3; ++c) {
      Mp50 expected = Mp50(map.shift[c]) * Mp50(2);
      for (int k = 0; k < 3; ++k) expected += Mp50(map.linear(c, k)) * Mp50(at[k]);
      EXPECT_NEAR(map(at, 2)[c], static_cast<double>(expected), std::abs(static_cast<double>(expected)) * 0x1p-52)
          << map.pose << ' ' << c;
    }
  }
}

}  // namespace
}  // namespace cageproof::validation
