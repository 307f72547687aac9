// SPDX-License-Identifier: MIT
// Second routes of deformers that solve for densities: what they are made of, agreement with the first route, and a
// disagreement that is seen.
#include "cageproof/core/cage/embedded_cages.h"
#include "deformers/deformer_campaign.h"
#include "cageproof/validation/promise.h"
#include "deformers/deformer_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cageproof::validation {
namespace {

// No face is parallel to an axis.
Cage tetrahedron() {
  std::vector<Face> faces;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) faces.push_back({{a, b, c, -1}});
  return Cage::make("tetrahedron", {{0, 0.1, -0.2}, {1.2, 0.2, 0.1}, {0.3, 1.1, 0}, {0.4, 0.3, 1.3}}, faces);
}

}  // namespace

TEST(deformer_routes, eliminate_with_pivots_and_square_sums) {
  using second_routes::Table;
  Table<Mp200> matrix(2, 2), right(2, 1);
  matrix(0, 1) = matrix(1, 0) = 2;
  right(0, 0) = 6;
  right(1, 0) = 4;
  const Table<Mp200> found = second_routes::eliminated(matrix, right);
  EXPECT_EQ(found(0, 0), 2);
  EXPECT_EQ(found(1, 0), 3);
  // The mean of 1 and 4, the second twice.
  second_routes::NormalEquations<Mp200> squares(1, 1);
  for (const int value : {1, 4}) {
    squares.row(0) = 1;
    squares.value(0) = value;
    squares.add(Mp200(value == 4 ? 2 : 1));
  }
  EXPECT_EQ(squares.solution()(0, 0), 3);
}

// The minimum over all numbers is (-1, 2); with none negative it lies on the border, and not where the second is two.
TEST(deformer_routes, minimise_over_numbers_that_are_not_negative) {
  using second_routes::Table;
  Table<Mp200> gram(2, 2), pull(2, 1);
  gram(0, 0) = gram(1, 1) = 2;
  gram(0, 1) = gram(1, 0) = 1;
  pull(0, 0) = 0;
  pull(1, 0) = 3;
  const Table<Mp200> found = second_routes::least_not_negative(gram, pull);
  EXPECT_EQ(found(0, 0), 0);
  EXPECT_EQ(found(1, 0), 1.5);
}

TEST(deformer_routes, solve_for_densities_as_deformers_do) {
  const auto errors = [](std::string_view name, const char* method) {
    const auto cage = std::make_shared<const Cage>(name == "tetrahedron" ? tetrahedron() : embedded_cage(name));
    const Vec3<double> point = interior_points(*cage, Triangulation::Shortest, 1, 1).front();
    std::map<std::string, double> found;
    for (const DeformerVariant& variant : variants_of(deformation::deform_method_named(method))) {
      const DeformerChecks checks(cage, variant, Triangulation::Shortest);
      for (const Question<PointAt>& question : checks.questions())
        if (question.key.check == "second_route") found[variant.name] = question.ask({point, 0})[0].error;
    }
    return found;
  };
  const auto expect = [&](const char* cage, const char* method, std::size_t variants) {
    const auto found = errors(cage, method);
    EXPECT_EQ(found.size(), variants) << cage << ' ' << method;
    for (const auto& [variant, error] : found) {
      const auto bound = promise_for({"second_route", method, variant, "mp50", "bent", 0}).bound;
      ASSERT_TRUE(bound);
      EXPECT_LE(error, *bound) << cage << ' ' << method << ' ' << variant;
    }
  };
  for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "ahap", "aaap", "tp"})
    for (const char* cage : {"square", "l-shape"}) expect(cage, method, 4);
  for (const char* method : {"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber", "ahap", "aaap", "tp"})
    expect("tetrahedron", method, 1);
  expect("cube", "biharmonic_1_3", 1);
  expect("twisted-bar", "biharmonic_1_3", 0);  // 36 triangles are too many
  expect("square", "green", 0);
}

// A vertex of the pose that is off by 1e-20 sizes.
TEST(deformer_routes, see_a_deformer_that_is_off_by_less_than_double_shows) {
  const Cage cage = embedded_cage("l-shape");
  const Vec3<double> point(0.5, 0.4, 0);
  for (const char* name : {"biharmonic_1_2", "tp"}) {
    const auto deformer = deformation::prepare_deformer<Mp50>(deformation::deform_method_named(name), cage, {});
    const auto variants = variants_of(deformation::deform_method_named(name));
    const auto method = layer_method_of(*std::ranges::find_if(variants, &DeformerVariant::is_default), cage.size());
    ASSERT_TRUE(method);
    const second_routes::LayerRoute route(deformer->coordinates(), *method, bent(cage));
    const auto error = [&](const Mp50& moved) {
      deformation::Pose<Mp50> pose;
      for (const Vec3<double>& v : bent(cage)) pose.vertices.push_back(convert<Mp50>(v));
      pose.vertices.front()[0] += moved;
      const Vec3<Mp50> at = convert<Mp50>(point);
      const auto images = deformer->images(*deformer->pose(pose), std::span(&at, 1), 0);
      const Vec3<Mp200> expected = route.image_of(point);
      return static_cast<double>(Mp200(abs(Mp200(images.tensors[0][0]) - expected[0])));
    };
    EXPECT_LT(error(Mp50(0)), 1e-40) << name;
    EXPECT_GT(error(Mp50("1e-20")), 1e-24) << name;
  }
}

}  // namespace cageproof::validation
