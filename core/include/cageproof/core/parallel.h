// SPDX-License-Identifier: MIT
// Loops on all cores. With oneTBB they share its threads; without it (CAGEPROOF_TBB=OFF) each loop starts its own.
#pragma once

#include <cstddef>
#include <functional>

namespace cageproof {

/// How many threads that many jobs are: 0 means one per core that this process may use.
int threads_for(int jobs);

/// Runs `task(i)` for i in [0, count) on `jobs` threads (0: all cores), begun in rising order. An exception ends the
/// loop and is thrown on. A loop within a task takes threads that are idle, and else its own.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task);

/// Runs `task(begin, end)` for ranges that make up [0, count), each at least `grain` long except the last, on all
/// cores. There are a few ranges per core, so that what a task prepares is prepared seldom.
void for_ranges_parallel(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t begin, std::size_t end)>& task);

}  // namespace cageproof
