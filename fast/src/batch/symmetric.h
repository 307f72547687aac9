// SPDX-License-Identifier: MIT
// Symmetric tensors of the space, of which each different entry is kept once.
#pragma once

#include <array>

namespace cageproof::closed_form::batch {

/// The number of entries of order N: one, x y z, xx xy xz yy yz zz, xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz ...
template <int N>
inline constexpr int kEntries = (N + 1) * (N + 2) / 2;

/// Where an entry of order N is that has one more index in front of an entry m of order N - 1: kWith<N>[index][m].
template <int N>
inline constexpr int kWith[3][kEntries<N - 1>] = {};
template <>
inline constexpr int kWith<1>[3][1] = {{0}, {1}, {2}};
template <>
inline constexpr int kWith<2>[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
template <>
inline constexpr int kWith<3>[3][6] = {{0, 1, 2, 3, 4, 5}, {1, 3, 4, 6, 7, 8}, {2, 4, 5, 7, 8, 9}};
template <>
inline constexpr int kWith<4>[3][10] = {
    {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 3, 4, 6, 7, 8, 10, 11, 12, 13}, {2, 4, 5, 7, 8, 9, 11, 12, 13, 14}};

template <class V, int N>
struct Symmetric {
  std::array<V, kEntries<N>> c;
  V& operator[](int i) { return c.data()[i]; }
  const V& operator[](int i) const { return c.data()[i]; }
};

/// Calls f(index, entry of the rest, entry) for each entry, the first of its indices in front. As a function of its own
/// it would keep all that f reads in memory.
template <int N, class F>
[[gnu::always_inline]] inline void for_each_entry(F f) {
  constexpr int rest = kEntries<N - 1>;
  // Entries of the rest that begin with the same index or a later one are the last ones.
  constexpr int first[3] = {0, rest - N, rest - 1};
  for (int i = 0; i < 3; ++i)
    for (int m = first[i]; m < rest; ++m) f(i, m, kWith<N>[i][m]);
}

}  // namespace cageproof::closed_form::batch
