// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/scalar.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

template <Scalar R>
void expect_largest_error_of_a_rounding() {
  const R u = unit_roundoff<R>();
  // A hundredth below it rounding goes down to one, a hundredth above it up, by twice as much.
  EXPECT_EQ(R(R(1) + u * R(99) / R(100)), R(1));
  EXPECT_EQ(R(R(1) + u * R(101) / R(100)), R(R(1) + R(2) * u));
}

TEST(scalar, unit_roundoff_is_the_largest_error_of_a_rounding) {
  EXPECT_EQ(unit_roundoff<float>(), 0x1p-24F);
  EXPECT_EQ(unit_roundoff<double>(), 0x1p-53);
  expect_largest_error_of_a_rounding<float>();
  expect_largest_error_of_a_rounding<double>();
  expect_largest_error_of_a_rounding<Mp50>();
  expect_largest_error_of_a_rounding<Mp100>();
  expect_largest_error_of_a_rounding<Mp200>();
}

TEST(scalar, kinds_have_names_and_are_found_by_them) {
  EXPECT_EQ(scalar_named("float"), ScalarKind::Float);
  EXPECT_EQ(scalar_named("double"), ScalarKind::Double);
  EXPECT_EQ(scalar_named("mp50"), ScalarKind::Digits50);
  EXPECT_EQ(scalar_named("mp100"), ScalarKind::Digits100);
  EXPECT_EQ(scalar_named("mp200"), ScalarKind::Digits200);
  EXPECT_EQ(scalar_named("mp300"), std::nullopt);
  for (const ScalarKind kind : scalar_kinds) EXPECT_EQ(scalar_named(name_of(kind)), kind);
}

}  // namespace
}  // namespace cageproof
