// SPDX-License-Identifier: MIT
// One loop on all cores, and what is made by whoever needs it first.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>

namespace cageproof::validation {

/// How many threads that many jobs are: 0 means one a core that this process may use.
int threads_for(int jobs);

/// Runs `task(i)` for i in [0, count) on `jobs` threads (0: all cores), begun in rising order. An exception ends the
/// loop and is thrown on.
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task);

/// A value made on first use, safe from any thread.
template <class T>
class Lazy {
 public:
  explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}
  const T& get() const {
    std::call_once(once_, [&] { value_.emplace(make_()); });
    return *value_;
  }

 private:
  std::function<T()> make_;
  mutable std::once_flag once_;
  mutable std::optional<T> value_;
};

}  // namespace cageproof::validation
