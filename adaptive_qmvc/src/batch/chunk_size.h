// SPDX-License-Identifier: MIT
// How many points are taken at a time.
#pragma once

#include <algorithm>
#include <cstddef>

namespace cageproof::adaptive_qmvc::batch {

/// Vectors of every instruction set.
inline constexpr std::size_t kWidest = 8;

inline std::size_t padded(std::size_t count) { return (count + kWidest - 1) / kWidest * kWidest; }

/// Points that see a quad alike fill vectors, of which more points leave fewer half empty; their sums stay in caches.
/// \param sums of a point
inline std::size_t points_a_chunk(std::size_t sums) {
  constexpr std::size_t most = 1024, least = 64, all_sums = std::size_t(1) << 17;
  return std::clamp(all_sums / sums / kWidest * kWidest, least, most);
}

}  // namespace cageproof::adaptive_qmvc::batch
