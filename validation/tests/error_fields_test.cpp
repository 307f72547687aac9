// SPDX-License-Identifier: MIT
#include "cageproof/validation/error_fields.h"

#include "cageproof/core/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

std::vector<double> sorted_difference(const char* evaluation) {
  const Cage cage = embedded_cage("twisted-bar");
  auto values = coordinate_difference_field(cage, *find_coordinate_kind("quad_mean_value"), evaluation, "closed_form", Triangulation::Shortest, 9, 0)
                    .arrays.front()
                    .values;
  std::ranges::sort(values);
  return values;
}

TEST(coordinate_difference_field, shows_what_the_scheme_is_off_by_and_nothing_of_the_line_form) {
  EXPECT_LT(sorted_difference("line-12").back(), 1e-11);
  const auto coarse = sorted_difference("riemann-4"), fine = sorted_difference("riemann-40");
  const std::size_t median = coarse.size() / 2;
  EXPECT_GT(coarse[median], 1e-5);
  EXPECT_LT(coarse.back(), 0.1);
  EXPECT_LT(fine[median], coarse[median] / 10);
}

}  // namespace
}  // namespace cageproof::validation
