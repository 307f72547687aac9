// SPDX-License-Identifier: MIT
#include "cageproof/core/lazy.h"
#include "cageproof/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace cageproof {
namespace {

TEST(parallel, each_index_is_run_once) {
  for (const int jobs : {0, 1, 3}) {
    std::vector<int> runs(1000);
    for_each_parallel(runs.size(), jobs, [&](std::size_t i) { ++runs[i]; });
    EXPECT_EQ(runs, std::vector<int>(1000, 1)) << jobs << " jobs";
  }
  for_each_parallel(0, 4, [](std::size_t) { FAIL() << "there is no index"; });
}

TEST(parallel, one_job_takes_one_thread_in_order) {
  std::vector<std::size_t> order;
  for_each_parallel(50, 1, [&](std::size_t i) { order.push_back(i); });
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(parallel, ranges_make_up_the_whole) {
  for (const std::size_t count : {0, 1, 7, 64, 1001})
    for (const std::size_t grain : {1, 16, 5000}) {
      std::vector<int> runs(count);
      std::mutex mutex;
      std::size_t ranges = 0;
      for_ranges_parallel(count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++runs[i];
        EXPECT_TRUE(end - begin >= grain || end == count) << begin << " to " << end;
        const std::scoped_lock lock(mutex);
        ++ranges;
      });
      EXPECT_EQ(runs, std::vector<int>(count, 1)) << count << " in ranges of " << grain;
      EXPECT_EQ(ranges == 0, count == 0);
    }
}

TEST(parallel, loops_within_a_loop_are_whole) {
  std::atomic<int> runs{0};
  for_each_parallel(20, 4, [&](std::size_t) {
    for_each_parallel(10, 0, [&](std::size_t) { ++runs; });
    for_ranges_parallel(10, 1, [&](std::size_t begin, std::size_t end) { runs += static_cast<int>(end - begin); });
  });
  EXPECT_EQ(runs, 400);
}

TEST(parallel, loops_within_one_job_stay_on_its_thread) {
  const std::thread::id own = std::this_thread::get_id();
  std::atomic<int> runs{0}, elsewhere{0};
  const auto task = [&](std::size_t) {
    ++runs;
    if (std::this_thread::get_id() != own) ++elsewhere;
    // Long enough for another thread to take part.
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  };
  for_each_parallel(2, 1, [&](std::size_t) {
    for_each_parallel(10, 0, task);
    for_each_parallel(10, 3, task);
    for_ranges_parallel(20, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) task(i);
    });
  });
  EXPECT_EQ(runs, 80);
  EXPECT_EQ(elsewhere, 0);
}

TEST(parallel, an_exception_ends_the_loop_and_reaches_the_caller) {
  std::atomic<int> runs{0};
  const auto task = [&](std::size_t i) {
    ++runs;
    if (i == 3) throw std::runtime_error("the fourth");
  };
  EXPECT_THROW(for_each_parallel(100000, 2, task), std::runtime_error);
  EXPECT_LT(runs, 100000);
}

TEST(parallel, a_lazy_value_is_made_once) {
  std::atomic<int> made{0};
  const Lazy<int> lazy([&] { return ++made; });
  EXPECT_EQ(made, 0);
  for_each_parallel(100, 4, [&](std::size_t) { EXPECT_EQ(lazy.get(), 1); });
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace cageproof
