// SPDX-License-Identifier: MIT
// Objects that tasks of a loop use one after the other, so that the next task finds memory where one before it left it.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cageproof {

/// Objects that are lent and given back: as many exist as were in use at once. They do not belong to threads, because a
/// thread that waits within a task may begin another task. Safe from any thread.
template <class T>
class Reused {
 public:
  /// One that nobody else has, until this goes.
  class Held {
   public:
    Held(Reused& from, std::unique_ptr<T> held) : from_(from), held_(std::move(held)) {}
    ~Held() { from_.give_back(std::move(held_)); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    T& operator*() { return *held_; }

   private:
    Reused& from_;
    std::unique_ptr<T> held_;
  };

  Held taken() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      // Reserved here, because giving an object back must not need memory: there may be none left then.
      free_.reserve(++made_);
      return Held(*this, std::make_unique<T>());
    }
    std::unique_ptr<T> one = std::move(free_.back());
    free_.pop_back();
    return Held(*this, std::move(one));
  }

 private:
  void give_back(std::unique_ptr<T> one) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(one));
  }

  std::mutex mutex_;
  std::size_t made_ = 0;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace cageproof
