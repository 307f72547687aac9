// SPDX-License-Identifier: MIT
#include "cageproof/judge/foreign.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

namespace cageproof::judge {
namespace {

TEST(foreign, is_found_by_its_name_and_has_its_role) {
  add_foreign("triangle.single_layer", "seven", 0, [](Evaluation& evaluation) {
    evaluation.set_point<double>([](const Query<double>& query, Result<double>& result) {
      result.reset(1, 3, query.order);
      result.value[0] = 7;
    });
  });
  const Evaluation found = evaluation_named("triangle.single_layer", "seven");
  EXPECT_EQ(found.role(), Role::Foreign);
  EXPECT_TRUE(found.supports<double>());
  EXPECT_FALSE(found.supports<float>());
}

TEST(foreign, refuses_names_that_are_taken_and_formulas_that_are_unknown) {
  EXPECT_THROW(add_foreign("triangle.single_layer", "closed_form", 0, [](Evaluation&) {}), InputError);
  EXPECT_THROW(add_foreign("triangle.nothing", "mine", 0, [](Evaluation&) {}), InputError);
}

}  // namespace
}  // namespace cageproof::judge
