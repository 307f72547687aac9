// SPDX-License-Identifier: MIT
#include "cageproof/validation/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace cageproof::validation {

int threads_for(int jobs) { return jobs > 0 ? jobs : tbb::info::default_concurrency(); }

void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task) {
  const int threads = threads_for(jobs);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  // A range cut in halves would begin half of it last. Tasks that take long come first where that matters, and the
  // threads end together.
  std::atomic<std::size_t> next{0};
  arena.execute([&] {
    tbb::parallel_for(
        0, threads,
        [&](int) {
          try {
            for (std::size_t i = next++; i < count; i = next++) task(i);
          } catch (...) {
            next = count;
            throw;
          }
        },
        tbb::simple_partitioner{});
  });
}

}  // namespace cageproof::validation
