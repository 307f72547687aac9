// SPDX-License-Identifier: MIT
// Energies of maps by constraints, written another time: known turns and energies, and maps that are stationary.
#include "cageproof/core/cage/embedded_cages.h"
#include "deformers/deformer_poses.h"
#include "cageproof/validation/promise.h"
#include "deformers/constrained_route.h"
#include "second_routes/thickness_energy.h"
#include "second_routes/variational_energy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

second_routes::MapTensor tensor_of(const Mat3<double>& matrix) {
  second_routes::MapTensor found;
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < 3; ++j) found.emplace_back(matrix(c, j));
  return found;
}

double distance_from(const second_routes::MapTensor& found, const Mat3<double>& expected) {
  double worst = 0;
  for (std::size_t k = 0; k < 9; ++k)
    worst = std::max(worst, std::abs(static_cast<double>(found[k]) -
                                     expected(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3))));
  return worst;
}

ConstrainedProblem problem_of(const deformation::ConstraintMethod& method, const Cage& cage, std::string_view pose) {
  return constrained_problem(method, cage, places_for(method, cage, Triangulation::Shortest), pose,
                             Triangulation::Shortest);
}

}  // namespace

TEST(constrained_routes, find_the_nearest_turn) {
  const Mat3<double> turned = turn(3).linear;
  Mat3<double> stretch = Mat3<double>::Identity();
  stretch.diagonal() << 2, 1, 0.5;
  stretch(0, 1) = stretch(1, 0) = 0.25;
  const second_routes::MapTensor jacobian = tensor_of(turned * stretch);
  EXPECT_LT(distance_from(second_routes::nearest_turn(jacobian, 3, false), turned), 1e-14);
  EXPECT_LT(distance_from(second_routes::nearest_turn(jacobian, 3, true), turned * (3.5 / 3)), 1e-14);
  // A mirror image is no rotation.
  Mat3<double> flipped = Mat3<double>::Identity();
  flipped(2, 2) = -0.1;
  EXPECT_LT(distance_from(second_routes::nearest_turn(tensor_of(flipped), 3, false), Mat3<double>::Identity()), 1e-14);
  const second_routes::MapTensor plane = second_routes::nearest_turn({Mp50(0), Mp50(-3), Mp50(1), Mp50(0)}, 2, true);
  EXPECT_EQ(plane[1], -2);
  EXPECT_EQ(plane[2], 2);
}

TEST(constrained_routes, sum_and_differentiate_energies) {
  const auto numbers = [](std::initializer_list<double> list) {
    return second_routes::MapTensor(list.begin(), list.end());
  };
  const second_routes::VariationalEnergy energy{
      Mp50(2), Mp50(3), Mp50(5), {numbers({1, 1})}, {numbers({1, 0, 0, 1})}, {numbers({0, 0, 0, 0})}};
  const second_routes::MapAtConstraints map{
      {numbers({2, 3})}, {numbers({1, 0, 0, 3})}, {numbers({1, 0, 0, 1})}, {numbers({0, 1, 1, 0, 0, 0, 0, 2})}};
  EXPECT_EQ(energy.of(map), 1 + 4 + 2 * 4 + 3 * 2 + 5 * 6);
  const second_routes::MapAtConstraints direction{
      {numbers({1, 0})}, {numbers({0, 0, 0, 1})}, {numbers({0, 0, 0, 0})}, {numbers({0, 0, 0, 0, 0, 0, 0, 1})}};
  EXPECT_LT(abs(Mp50(energy.slope(map, direction) - (2 + 2 * 4 + 5 * 4))), Mp50("1e-40"));
}

TEST(constrained_routes, find_maps_stationary) {
  for (const char* name : {"cube", "square", "l-shape"}) {
    const Cage cage = embedded_cage(name);
    for (const deformation::ConstraintMethod& method : deformation::constraint_methods()) {
      if (!can_be_asked(method, cage, Triangulation::Shortest)) continue;
      const ConstrainedProblem problem = problem_of(method, cage, bent_pose).under(turn(cage.dimension()), 1);
      for (ConstrainedVariant& variant : variants_of(method)) {
        const auto bound = promise_for({"second_route", method.name, variant.name, "double", "bent", 0}).bound;
        ASSERT_TRUE(bound) << method.name;
        EXPECT_LE(unmet_stationarity(problem, variant, Triangulation::Shortest), *bound)
            << name << ' ' << method.name << ' ' << variant.name;
        if (method.positions_alone) continue;
        variant.parameters[1] = 1;  // rotations=similar
        EXPECT_LE(unmet_stationarity(problem, variant, Triangulation::Shortest), *bound)
            << name << ' ' << method.name << ' ' << variant.name << ", similar";
      }
    }
  }
}

// The same pose with a vertex that is off by a millionth.
TEST(constrained_routes, see_a_pose_that_is_not_stationary) {
  const Cage cage = embedded_cage("l-shape");
  const auto& method = *deformation::find_constraint_method("thickness");
  const ConstrainedProblem problem = problem_of(method, cage, bent_pose);
  const auto model = problem.prepared(variants_of(method).front(), Triangulation::Shortest, 400);
  std::vector<Vec3<double>> at;
  at.reserve(problem.constraints.positions.size());
  for (const auto& position : problem.constraints.positions) at.push_back(position.at);
  const second_routes::ThicknessEnergy energy(model->coordinates(), 4, at);
  second_routes::ThicknessEnergy::Unknowns vertices;
  for (const Vec3<double>& v : model->pose()->vertices()) vertices.insert(vertices.end(), {Mp50(v[0]), Mp50(v[1])});
  EXPECT_LT(energy.slope_along_constraints(vertices), 1e-7);
  vertices[3] += 1e-6;
  EXPECT_GT(energy.slope_along_constraints(vertices), 1e-7);
  // At rest nothing bends.
  second_routes::ThicknessEnergy::Unknowns rest;
  for (const Vec3<double>& v : cage.vertices()) rest.insert(rest.end(), {Mp50(v[0]), Mp50(v[1])});
  EXPECT_LT(energy.of(rest), 1e-20);
  EXPECT_LT(abs(Mp50(energy.images(rest)[0] - at[0][0])), 1e-12);
}

}  // namespace cageproof::validation
