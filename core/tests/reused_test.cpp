// SPDX-License-Identifier: MIT
#include "cageproof/core/reused.h"

#include "cageproof/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>

namespace cageproof {
namespace {

TEST(reused, nobody_else_has_what_is_held) {
  struct Counter {
    std::atomic<int> users{0};
  };
  Reused<Counter> counters;
  std::atomic<int> shared = 0;
  for_each_parallel(1000, 3, [&](std::size_t) {
    auto held = counters.taken();
    if (++(*held).users != 1) ++shared;
    // A loop within may begin another task on this thread.
    for_ranges_parallel(4, 1, [](std::size_t, std::size_t) {});
    --(*held).users;
  });
  EXPECT_EQ(shared, 0);
}

TEST(reused, what_is_given_back_is_taken_again) {
  Reused<int> numbers;
  std::set<const int*> seen;
  for (int i = 0; i < 5; ++i) {
    auto first = numbers.taken(), second = numbers.taken();
    EXPECT_NE(&*first, &*second);
    seen.insert({&*first, &*second});
  }
  EXPECT_EQ(seen.size(), 2U);
}

}  // namespace
}  // namespace cageproof
