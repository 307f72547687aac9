// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace cageproof::cage_checks {

/// Sets of connected vertices.
class Connected {
 public:
  explicit Connected(std::size_t count) : towards_(count) { std::iota(towards_.begin(), towards_.end(), 0); }
  int root(int v) {
    while (towards_[v] != v) v = towards_[v] = towards_[towards_[v]];
    return v;
  }
  void join(int a, int b) { towards_[root(a)] = root(b); }

 private:
  std::vector<int> towards_;
};

}  // namespace cageproof::cage_checks
