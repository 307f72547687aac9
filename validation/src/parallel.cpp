// SPDX-License-Identifier: MIT
#include "cageproof/validation/campaign.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace cageproof::validation {

void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task) {
  const int threads = jobs > 0 ? jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { task(i); }, tbb::simple_partitioner{});
  });
}

}  // namespace cageproof::validation
