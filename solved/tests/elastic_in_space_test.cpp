// SPDX-License-Identifier: MIT
// Elastic bodies in cages in space: what holds for any scheme, and displacements that are known.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "elastic_space_support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::elastic_in_space_test {
namespace {

// Affine displacements have constant tractions on each face, which the scheme contains.
TEST(elastic_in_space, affine_displacements_are_kept_at_any_level) {
  const Eigen::Matrix3d map{{2, -1, 0.5}, {0.25, 3, -0.75}, {-1.5, 0.125, 1}};
  const auto u = [&](const Vec& p) { return Vec(map * p + Vec(0.5, -1, 2)); };
  for (const char* name : {"cube", "l-block", "twisted-bar", "spiky-box"})
    for (const double nu : {-0.9, 0.3, 0.49}) {
      const CageCoordinates e = elastic_at_level(embedded_cage(name), 0, nu);
      for (const Vec& p : inner_points(e.elements(), 3)) {
        EXPECT_LT((displaced(e, u, p) - u(p)).norm(), 1e-12) << name << ' ' << nu;
        const auto found = e.at<double>(p, 1)[0];
        for (int i = 0; i < 3; ++i)
          EXPECT_LT((sum_of(e, found.gradient, u, 3, i) - map.col(i)).norm(), 1e-9) << name << ' ' << nu;
      }
    }
  const CageCoordinates finer = elastic_at_level(embedded_cage("l-block"), 1, 0.3);
  for (const Vec& p : inner_points(finer.elements(), 4)) EXPECT_LT((displaced(finer, u, p) - u(p)).norm(), 1e-12);
}

TEST(elastic_in_space, infinitesimal_rotations_are_kept) {
  const Vec axis(0.3, -1, 0.5);
  const auto u = [&](const Vec& p) { return Vec(axis.cross(p)); };
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, 0.3);
  for (const Vec& p : inner_points(e.elements(), 3)) EXPECT_LT((displaced(e, u, p) - u(p)).norm(), 1e-13);
}

// A force (1, 2, -1) at a pole outside displaces like this, times a constant (Kelvin).
std::function<Vec(const Vec&)> kelvin(const Vec& pole, double nu) {
  return [pole, nu](const Vec& p) {
    const Vec force(1, 2, -1), x = p - pole;
    const double r = x.norm();
    return Vec((3 - 4 * nu) / r * force + x.dot(force) / (r * r * r) * x);
  };
}

TEST(elastic_in_space, forces_outside_are_met_to_second_order) {
  for (const double nu : {-0.5, 0.45}) {
    const auto u = kelvin(Vec(1.25, 0.75, -0.5), nu);
    std::array<double, 2> errors{};
    for (int times = 1; times <= 2; ++times) {
      const CageCoordinates e = elastic_at_level(split_cage(embedded_cage("cube"), times), 0, nu);
      for (const Vec& p : {Vec(0.1, 0.2, 0.3), Vec(0, 0, 0), Vec(-0.25, 0.125, 0.375), Vec(0.25, 0.25, -0.3)})
        errors[times - 1] = std::max(errors[times - 1], (displaced(e, u, p) - u(p)).norm());
    }
    RecordProperty("errors", testing::PrintToString(errors));
    EXPECT_LT(errors[0], 0.2) << nu;
    EXPECT_LT(errors[1], errors[0] / 3.5) << nu;
    EXPECT_GT(errors[1], 1e-5) << "a study of errors that has none";
  }
}

// One vertex is displaced, which no polynomial is.
TEST(elastic_in_space, levels_converge) {
  std::array<std::vector<double>, 3> found;
  for (int level = 0; level < 3; ++level)
    found[level] = values_at(elastic_at_level(embedded_cage("cube"), level, 0.3), Vec(0.1, 0.2, 0.3));
  const double coarse = largest_difference(found[0], found[1]), fine = largest_difference(found[1], found[2]);
  EXPECT_LT(fine, coarse / 2.5) << coarse;
  EXPECT_GT(fine, 1e-5) << "a study of errors that has none";
}

TEST(elastic_in_space, say_what_was_solved) {
  const CageCoordinates e = elastic_at_level(embedded_cage("cube"), 1, 0.3);
  ASSERT_EQ(e.solved().size(), 1u);
  const SolvedSystem system = e.solved()[0];
  EXPECT_EQ(system.rows, 12 * 4 * 3);
  EXPECT_EQ(system.rank, system.rows);
  EXPECT_GT(system.condition, 5);
  EXPECT_LT(system.condition, 500);
  EXPECT_LT(system.residual, 1e-14);
  // Where bodies keep their volume, pressure moves nothing: the condition grows like 1/(1 - 2 nu).
  const double near = elastic_at_level(embedded_cage("cube"), 1, 0.5 - 1e-6).solved()[0].condition;
  EXPECT_GT(near, 1e5);
  EXPECT_LT(near, 1e8);
}

}  // namespace
}  // namespace cageproof::solved::test::elastic_in_space_test
