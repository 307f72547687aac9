// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/role.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

// Reports and JSON know roles and costs by these names.
TEST(role, has_its_own_name) {
  EXPECT_EQ(name_of(Role::Recommended), "recommended");
  EXPECT_EQ(name_of(Role::Plain), "plain");
  EXPECT_EQ(name_of(Role::Stated), "stated");
  EXPECT_EQ(name_of(Role::Rule), "rule");
  EXPECT_EQ(name_of(Role::Integral), "integral");
  EXPECT_EQ(name_of(Role::Enclosure), "enclosure");
  EXPECT_EQ(name_of(Role::Printed), "printed");
  EXPECT_EQ(name_of(Role::Scheme), "scheme");
  EXPECT_EQ(name_of(Role::Batched), "batched");
  EXPECT_EQ(name_of(Role::Foreign), "foreign");
}

TEST(cost, has_its_own_name) {
  EXPECT_EQ(name_of(CostClass::Direct), "direct");
  EXPECT_EQ(name_of(CostClass::Nodes), "nodes");
  EXPECT_EQ(name_of(CostClass::Adaptive), "adaptive");
  EXPECT_EQ(name_of(CostClass::Multiprecision), "multiprecision");
}

}  // namespace
}  // namespace cageproof
