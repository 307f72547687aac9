// SPDX-License-Identifier: MIT
// The time that asking foreign code takes beside the code's own: docs/judge.md has the figures that this prints.
#include "cageproof/judge/foreign_code.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <limits>

namespace cageproof::judge {
namespace {

// Microseconds per point, the least of some repeats. \param points of each element
double microseconds(const std::string& what, std::size_t elements, std::size_t points) {
  Limits limits;
  limits.host = {JUDGE_TEST_HOST};
  ForeignCode code(what, limits);
  Asked asked{.corners = {0, 0, 0, 1, 0, 0, 0, 1, 0}, .count = points};
  for (std::size_t i = 0; i < 3 * points; ++i) asked.points.push_back(1 + 1 / (3.0 + static_cast<double>(i)));
  const std::vector<Asked> all(elements, asked);
  const Request request{.formula = &formula_named("triangle.single_layer")};
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
    for (const Answer& answer : code.ask(request, all)) EXPECT_EQ(answer.status, Answer::Status::Given);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count() / static_cast<double>(elements * points));
  }
  return least;
}

void expect_at_most(double bound, const std::string& what, const std::string& how, std::size_t elements,
                    std::size_t points) {
  const double found = microseconds(what, elements, points);
  std::cout << fmt::format("{}, blocks of {}: {:.3g} us a point\n", how, points, found);
  EXPECT_LT(found, bound) << how;
}

// The goals are 20 us a line and 1 us a point in a block. Bounds are ten times these, since tests run beside others,
// and under sanitizers.
TEST(judge_cost, of_a_line_is_far_below_a_millisecond) {
  expect_at_most(200, JUDGED_QUICK, "program", 2000, 1);
  expect_at_most(200, JUDGED_QUICK, "program", 40, 64);
}

TEST(judge_cost, of_a_point_in_a_block_is_far_below_that_of_a_line) {
  expect_at_most(100, JUDGED_LIBRARIES "/quick.so", "library", 2000, 1);
  expect_at_most(10, JUDGED_LIBRARIES "/quick.so", "library", 2000, 64);
}

}  // namespace
}  // namespace cageproof::judge
