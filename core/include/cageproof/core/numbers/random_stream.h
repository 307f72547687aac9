// SPDX-License-Identifier: MIT
// Counter-based random numbers (Philox, Random123): a stream is a pure function of its key.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cageproof {

/// Uniform numbers that depend on (seed, name, index) alone, never on what was drawn elsewhere.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t index);
  std::uint64_t bits();
  /// Uniform in [0, 1), 53 bits.
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in {0, ..., n - 1}. \pre n > 0
  int below(int n) { return static_cast<int>(uniform() * n); }

 private:
  std::array<std::uint64_t, 2> key_;
  std::array<std::uint64_t, 4> counter_;
  std::array<std::uint64_t, 4> block_{};
  int used_ = 4;
};

}  // namespace cageproof
