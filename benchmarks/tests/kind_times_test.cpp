// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/kind_times.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::benchmarks {
namespace {

const EvaluationTime* time_of(const std::vector<EvaluationTime>& times, std::string_view kind) {
  const auto found = std::ranges::find(times, kind, &EvaluationTime::formula);
  return found == times.end() ? nullptr : &*found;
}

TEST(KindTimes, AreOfTheKindsThatAcceptTheCageByWhatCommandsTake) {
  const std::vector<EvaluationTime> cube = times_of_kinds(embedded_cage("cube"), Triangulation::Shortest);
  const EvaluationTime* const green = time_of(cube, "green");
  ASSERT_NE(green, nullptr);
  EXPECT_EQ(green->evaluation, "batched");
  EXPECT_GT(green->nanoseconds, 10);
  EXPECT_LT(green->nanoseconds, 1e6);
  EXPECT_EQ(time_of(cube, "cauchy"), nullptr) << "a kind of polygons";
  const std::vector<EvaluationTime> square = times_of_kinds(embedded_cage("square"), Triangulation::Shortest);
  EXPECT_NE(time_of(square, "cauchy"), nullptr);
}

}  // namespace
}  // namespace cageproof::benchmarks
