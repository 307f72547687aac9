// SPDX-License-Identifier: MIT
// Maps that the elastic deformer keeps, exactly or to first order.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test {
namespace {

Case elastic_l() {
  return polygon("l", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                 {{0.2, 0}, {0.1, 0.3}, {-0.4, 0.2}, {0, 0}, {0.3, -0.2}, {0, 0.5}}, {0.625, 0.5, 0});
}

Vec elastic_image(const Case& c, const std::vector<Vec>& posed) {
  const auto deformer = prepare_deformer<double>(deform_method_named("elastic"), c.cage, {});
  const std::vector<double> found =
      deformer->images(*deformer->pose({posed}), std::vector<Vec>{c.points[0]}, 0).tensors[0];
  return {found[0], found[1], 0};
}

// The pose by so much of its steps, turned.
std::vector<Vec> turned_part(const Case& c, double share, double angle) {
  const Eigen::AngleAxisd turn(angle, Vec::UnitZ());
  std::vector<Vec> posed;
  for (std::size_t v = 0; v < c.posed.size(); ++v) {
    const Vec& rest = c.cage.vertices()[v];
    posed.push_back(turn * (rest + share * (c.posed[v] - rest)));
  }
  return posed;
}

TEST(elastic, images_are_linear_in_the_pose) {
  const Case c = elastic_l();
  const Vec whole = elastic_image(c, turned_part(c, 1, 0)) - c.points[0],
            half = elastic_image(c, turned_part(c, 0.5, 0)) - c.points[0];
  EXPECT_LT((whole - 2 * half).norm(), 1e-14);
  EXPECT_GT(whole.norm(), 0.02);
}

// Turning a pose turns its image where the pose is rigid; else by what the turn and the pose are multiplied.
TEST(elastic, turns_of_poses_are_kept_to_first_order) {
  const Case c = elastic_l();
  const auto missed = [&](double share, double angle) {
    return (elastic_image(c, turned_part(c, share, angle)) -
            Eigen::AngleAxisd(angle, Vec::UnitZ()) * elastic_image(c, turned_part(c, share, 0)))
        .norm();
  };
  EXPECT_LT(missed(0, 2), 1e-14);
  const double large = missed(0.1, 0.1), small = missed(0.05, 0.05);
  EXPECT_NEAR(small / large, 0.25, 0.01);
  EXPECT_GT(missed(1, 1.5), 5e-3);
}

TEST(elastic, the_condition_next_to_one_half_is_reported) {
  const Case c = elastic_l();
  const auto warnings = [&](double nu) {
    return prepare_deformer<double>(deform_method_named("elastic"), c.cage, {.parameters = {4, 1, nu, 1}})
        ->prepared()
        .warnings;
  };
  EXPECT_TRUE(warnings(0.3).empty());
  ASSERT_EQ(warnings(0.5 - 1e-8).size(), 1u);
  EXPECT_NE(warnings(0.5 - 1e-8)[0].find("the condition is"), std::string::npos);
  EXPECT_THROW(warnings(0.5), InputError);
  EXPECT_THROW(warnings(-1), InputError);
}

}  // namespace
}  // namespace cageproof::deformation::test
