// SPDX-License-Identifier: MIT
// Checks of elements and cages in the plane, shown a form that is right and forms that are wrong.
#include "plane_form.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_points.h"
#include "cages/cage_symmetries.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/regime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation::plane_test {
namespace {

const Formula& formula() { return *find_formula("segment.single_layer"); }

// The truth as the form itself gives it: what is tested is how checks change the input.
TruthSource source() {
  const Evaluation form = test::plane_form();
  return {.evaluation = form, .values = form, .confirmation = form, .yardstick = form};
}

// Wrong by a term of 1e-6 that no motion, unit or orientation keeps.
Evaluation broken() {
  Evaluation bad = test::plane_form();
  bad.set_point<double>([](const Query<double>& query, Result<double>& result) {
    test::plane_single_layer(query, result);
    const double x = query.point[0] + 2 * query.corners[0][1] + 0.3;
    for (int o = 0; o <= query.order; ++o)
      for (double& entry : result.of(o)) entry += 1e-6 * x * x * x;
  });
  return bad;
}

double largest(const Check& check, const Evaluation& evaluation) {
  double worst = -1;
  for (const char* regime : {"generic", "near-face", "far"})
    // The form is not stabilised: farther away than 1e4 it loses more than it may.
    for (std::uint64_t i = 0; i < (regime == std::string_view("far") ? 4 : 8); ++i) {
      const Sample sample = make_sample(formula(), *find_regime(regime), 2, i);
      const Truth truth = truth_from(source(), sample, 1);
      ResultsAtSample results(sample);
      const auto findings = check.measure({formula(), evaluation, ScalarKind::Double, sample, 1, truth, results});
      for (int o = 0; o < 2; ++o)
        if (findings[o].status == Finding::Status::Measured) worst = std::max(worst, findings[o].error);
    }
  return worst;
}

class PlaneCheck : public testing::TestWithParam<const char*> {};

TEST_P(PlaneCheck, passes_the_form_and_fails_a_broken_one) {
  const Check& check = *find_check(GetParam());
  // The form is not stabilised: near its line it loses digits that a closed form keeps.
  EXPECT_LT(largest(check, test::plane_form()), 1e6);
  EXPECT_GT(largest(check, test::plane_form()), -1);
  EXPECT_GT(largest(check, broken()), 1e8);
}

INSTANTIATE_TEST_SUITE_P(properties, PlaneCheck,
                         testing::Values("scaling", "rigid_motion", "orientation_flip", "truth"),
                         [](const auto& name) { return std::string(name.param); });

TEST(plane_yardstick, moves_no_point_out_of_the_plane) {
  Evaluation form = test::plane_form();
  form.set_point<Mp100>([](const Query<Mp100>& query, Result<Mp100>& result) {
    EXPECT_EQ(query.point[2], 0);
    for (const auto& corner : query.corners) EXPECT_EQ(corner[2], 0);
    test::plane_single_layer(query, result);
  });
  const Sample sample = make_sample(formula(), *find_regime("generic"), 2, 1);
  const Truth truth =
      truth_from({.evaluation = form, .values = form, .confirmation = form, .yardstick = form}, sample, 1);
  ASSERT_TRUE(truth.exists[0] && truth.exists[1]);
  EXPECT_GT(truth.conditioned[0], truth.norm[0]);
}

TEST(plane_checks, starting_at_the_other_end_is_no_permutation) {
  const Evaluation form("segment.single_layer", "closed_form", {.description = "", .role = Role::Recommended});
  EXPECT_FALSE(find_check("corner_permutation")->applies(formula(), form, ScalarKind::Double, "generic"));
  EXPECT_TRUE(find_check("scaling")->applies(formula(), form, ScalarKind::Double, "generic"));
  EXPECT_TRUE(find_check("subdivision")->applies(formula(), form, ScalarKind::Double, "generic"));
}

const RegisterEvaluation registered{single_family("segment.single_layer", "test_form",
                                                  {.description = "for tests", .role = Role::Foreign, .max_order = 1},
                                                  false, [](Evaluation& form) { form = test::plane_form(); })};
const RegisterEvaluation registered_broken{single_family(
    "segment.single_layer", "broken_form", {.description = "broken on purpose", .role = Role::Foreign, .max_order = 1},
    false, [](Evaluation& form) {
      for (const ScalarKind kind : scalar_kinds)
        with_scalar(kind, [&]<Scalar R>() {
          form.set_point<R>([](const Query<R>& query, Result<R>& result) {
            test::plane_single_layer(query, result);
            result.value[0] += (query.point[0] + 2 * query.corners[0][1] + 1) / 1000000;
          });
        });
    })};

TEST(plane_cage, symmetries_hold_for_the_form_and_fail_for_a_broken_one) {
  static const CoordinateKind kind{
      .name = "psi in the plane", .source = "", .blocks = {{"psi", "single_layer", Reproduces::Normals}}};
  const Cage square = embedded_cage("square");
  for (const std::string evaluation : {"test_form", "broken_form"}) {
    const CageSymmetries symmetries(square, kind, evaluation, Triangulation::Shortest);
    const auto errors = symmetries.errors_at(Vec3<double>(0.31, 0.45, 0));
    ASSERT_EQ(errors.size(), 3u);
    for (const char* check : {"cage_scaling", "cage_rigid_motion", "cage_subdivision"}) {
      ASSERT_TRUE(errors.contains(check)) << check;
      EXPECT_EQ(errors.at(check).relative > 1e-12, evaluation == "broken_form")
          << check << ' ' << errors.at(check).relative;
    }
  }
}

// Where ln r is nearly nothing along long edges, another unit adds terms a thousand times larger than all there are.
TEST(plane_cage, another_unit_adds_terms_that_are_rounded_too) {
  const CageSymmetries symmetries(embedded_cage("thin-bar"), coordinate_kind_named("green"), "closed_form",
                                  Triangulation::Shortest);
  for (int k = 0; k < 50; ++k) {
    const auto errors = symmetries.errors_at(Vec3<double>(0.001 * k, 0.8483, 0));
    EXPECT_LT(errors.at("cage_scaling").roundings, 16) << k;
  }
}

TEST(plane_cage, points_on_it_are_its_vertices_and_points_within_segments) {
  static const CoordinateKind kind{
      .name = "psi in the plane", .source = "", .blocks = {{"psi", "single_layer", Reproduces::Normals}}};
  const Cage square = embedded_cage("square");
  const CageCoordinates coordinates(square, kind, "test_form", Triangulation::Shortest);
  int vertices = 0, within = 0;
  for (const CagePoint& p : points_on(coordinates, square)) {
    EXPECT_NE(p.place, Place::OnEdge);
    EXPECT_EQ(coordinates.elements().touching(p.point).size(), p.place == Place::OnVertex ? 2u : 1u);
    (p.place == Place::OnVertex ? vertices : within) += 1;
  }
  EXPECT_EQ(vertices, 4);
  EXPECT_EQ(within, 12);  // at 1/4, 5/16 and 1/2 of each edge
}

}  // namespace
}  // namespace cageproof::validation::plane_test
