// SPDX-License-Identifier: MIT
// Memory that ends where a page begins that nobody may touch, so that a step too far is noticed.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace cageproof::judge {

class Guarded {
 public:
  explicit Guarded(const char* name) : name_(name) {}
  ~Guarded() { release(); }
  Guarded(const Guarded&) = delete;
  Guarded& operator=(const Guarded&) = delete;

  /// An array of that many, up to the guarded page; what an earlier call gave is gone. \throws std::bad_alloc
  template <class R>
  R* take(std::size_t count) {
    const std::size_t bytes = count * sizeof(R);
    if (bytes > size_ || begin_ == nullptr) grow(bytes);
    return reinterpret_cast<R*>(begin_ + size_ - bytes);
  }
  bool is_guard(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address), end = reinterpret_cast<std::uintptr_t>(begin_ + size_);
    return begin_ != nullptr && at >= end && at < end + page();
  }
  const char* name() const { return name_; }

 private:
  static std::size_t page() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }
  void release() {
    if (begin_ != nullptr) munmap(begin_, size_ + page());
    begin_ = nullptr;
  }
  void grow(std::size_t bytes) {
    release();
    size_ = (2 * bytes / page() + 1) * page();
    void* const memory = mmap(nullptr, size_ + page(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    begin_ = static_cast<char*>(memory);
    mprotect(begin_ + size_, page(), PROT_NONE);
  }

  const char* name_;
  char* begin_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace cageproof::judge
