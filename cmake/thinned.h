// SPDX-License-Identifier: MIT
// Tests that cost minutes take every third of their inputs at each change, and all of them at night.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof {

/// 1 where CAGEPROOF_TESTS is `all`, as .ci/nightly sets it, else 3. Regimes that take turns by 2, 4 or 8 are all met.
inline int test_stride() {
  const char* asked = std::getenv("CAGEPROOF_TESTS");
  return asked != nullptr && std::string_view(asked) == "all" ? 1 : 3;
}

/// Every test_stride()th of all, from the first on.
template <class T>
std::vector<T> thinned(std::vector<T> all, std::size_t first = 0) {
  std::vector<T> found;
  const auto stride = static_cast<std::size_t>(test_stride());
  found.reserve(all.size() / stride + 1);
  for (std::size_t i = first % stride; i < all.size(); i += stride) found.push_back(std::move(all[i]));
  return found;
}

}  // namespace cageproof
