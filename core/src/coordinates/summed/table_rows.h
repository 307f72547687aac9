// SPDX-License-Identifier: MIT
// One point's part of tables of coordinates, and changes of its unit.
#pragma once

#include "cageproof/core/coordinates/prepared_coordinates.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace cageproof {

// A point in the unit 2^-exponent, exactly.
template <Scalar R>
Vec3<R> in_unit(const Vec3<R>& p, int exponent) {
  using std::ldexp;
  return exponent == 0 ? p : Vec3<R>(ldexp(p[0], exponent), ldexp(p[1], exponent), ldexp(p[2], exponent));
}

template <Scalar R>
bool are_finite(std::span<const R> numbers) {
  return std::ranges::all_of(numbers, [](const R& x) { return x - x == R(0); });
}

// A point's part of a table.
template <Scalar R>
std::span<R> row_of(CoordinateTable<R>& table, std::size_t p, int o) {
  return std::span<R>(table.tensors[o]).subspan(p * table.stride[o], table.stride[o]);
}

template <Scalar R>
bool is_finite(std::size_t p, int order, std::span<CoordinateTable<R>> tables) {
  for (CoordinateTable<R>& table : tables)
    for (int o = 0; o <= order; ++o)
      if (!are_finite<R>(row_of(table, p, o))) return false;
  return true;
}

template <Scalar R>
void clear(std::size_t p, int order, std::span<CoordinateTable<R>> tables) {
  for (CoordinateTable<R>& table : tables)
    for (int o = 0; o <= order; ++o) std::ranges::fill(row_of(table, p, o), R(0));
}

// One point's tables, rounded to a place in others.
template <Scalar R, Scalar W>
void put_rounded(const std::vector<CoordinateTable<W>>& wide, std::size_t p, int order,
                 std::span<CoordinateTable<R>> tables) {
  for (std::size_t b = 0; b < wide.size(); ++b)
    for (int o = 0; o <= order; ++o)
      std::ranges::transform(wide[b].tensors[o], row_of(tables[b], p, o).begin(),
                             [](const W& x) { return static_cast<R>(x); });
}

}  // namespace cageproof
