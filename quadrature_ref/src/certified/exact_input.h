// SPDX-License-Identifier: MIT
// An element's corners and the point, exactly.
#pragma once

#include "ball.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <algorithm>
#include <array>
#include <optional>

namespace cageproof::quadrature_ref::certified {

using Vector = std::array<Real, 3>;

/// The corners and, last, the point.
template <std::size_t Corners>
using ExactInput = std::array<Vector, Corners + 1>;

/// The most bits that coordinates may spread over: exact arithmetic needs at least so many.
inline constexpr slong widest_spread = 20000;

/// The input as exact numbers; nothing if it is not finite, or its coordinates spread over more than 2^widest_spread.
template <std::size_t Corners, Scalar R>
std::optional<ExactInput<Corners>> exact_input(const Query<R>& query) {
  using std::isfinite;
  slong lowest = 0, highest = 0;
  bool any = false;
  const auto read = [&](const Vec3<R>& from, Vector& to) {
    for (int i = 0; i < 3; ++i) {
      if (!isfinite(from[i])) return false;
      to[i] = Real::exactly(from[i]);
      if (to[i].is_zero()) continue;
      const double log2 = to[i].log2_size();
      if (std::abs(log2) > 1e9) return false;
      const auto exponent = static_cast<slong>(log2);
      lowest = any ? std::min(lowest, exponent) : exponent;
      highest = any ? std::max(highest, exponent) : exponent;
      any = true;
    }
    return true;
  };
  ExactInput<Corners> input;
  if (!read(query.point, input[Corners])) return std::nullopt;
  for (std::size_t k = 0; k < Corners; ++k)
    if (!read(query.corners[k], input[k])) return std::nullopt;
  if (highest - lowest > widest_spread) return std::nullopt;
  return input;
}

}  // namespace cageproof::quadrature_ref::certified
