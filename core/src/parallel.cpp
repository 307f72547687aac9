// SPDX-License-Identifier: MIT
#include "cageproof/core/parallel.h"

#ifdef CAGEPROOF_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#else
#include <mutex>
#include <thread>
#include <vector>
#endif

#include <algorithm>
#include <atomic>
#include <exception>

namespace cageproof {
namespace {

// Takes the next index until there is none. A range cut in halves would begin half of it last: tasks that take long
// come first where that matters, and the threads end together.
class Work {
 public:
  Work(std::size_t count, const std::function<void(std::size_t)>& task) : count_(count), task_(task) {}
  void run() {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) task_(i);
    } catch (...) {
      next_ = count_;
      throw;
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& task_;
  std::atomic<std::size_t> next_{0};
};

// Whether loops within a task stay on its thread: within a loop of one job.
thread_local bool stays = false;

class Staying {
 public:
  Staying() : before_(stays) { stays = true; }
  ~Staying() { stays = before_; }
  Staying(const Staying&) = delete;
  Staying& operator=(const Staying&) = delete;

 private:
  bool before_;
};

#ifdef CAGEPROOF_TBB

void run_on(int threads, Work& work) {
  tbb::parallel_for(
      0, threads, [&](int) { work.run(); }, tbb::simple_partitioner{});
}

#else

void run_on(int threads, Work& work) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&] {
    // The other threads are busy with this loop.
    const Staying here;
    try {
      work.run();
    } catch (...) {
      const std::scoped_lock lock(mutex);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

#endif

}  // namespace

int threads_for(int jobs) {
  if (jobs > 0) return jobs;
#ifdef CAGEPROOF_TBB
  return tbb::info::default_concurrency();
#else
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
#endif
}

void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task) {
  const int threads = stays ? 1 : threads_for(jobs);
  if (threads == 1) {
    // Without an arena, which takes microseconds.
    const Staying here;
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
#ifdef CAGEPROOF_TBB
  // One task needs no arena where its own loops have as many threads without.
  if (count == 1 && threads == tbb::this_task_arena::max_concurrency()) return task(0);
#endif
  Work work(count, task);
#ifdef CAGEPROOF_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  arena.execute([&] { run_on(threads, work); });
#else
  run_on(threads, work);
#endif
}

void for_ranges_parallel(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t begin, std::size_t end)>& task) {
#ifdef CAGEPROOF_TBB
  const int threads = stays ? 1 : tbb::this_task_arena::max_concurrency();
#else
  const int threads = stays ? 1 : threads_for(0);
#endif
  constexpr std::size_t ranges_per_thread = 4;
  const std::size_t most = ranges_per_thread * static_cast<std::size_t>(threads);
  const std::size_t length = std::max({grain, (count + most - 1) / most, std::size_t{1}});
  if (count <= length || threads == 1) {
    if (count > 0) task(0, count);
    return;
  }
  const std::function<void(std::size_t)> range = [&](std::size_t i) {
    task(i * length, std::min(count, (i + 1) * length));
  };
  Work work((count + length - 1) / length, range);
  run_on(threads, work);
}

}  // namespace cageproof
