// SPDX-License-Identifier: MIT
// The common beginning of all elements' frames: corners relative to the point, in a unit of length close to the
// element's extent as the point sees it.
#pragma once

#include "power_of_two.h"
#include "vectors.h"

#include <algorithm>
#include <array>
#include <span>

namespace cageproof::quadrature_ref {

/// Corners v_k - eta and the first `E` edges v_{k+1} - v_k of an element, in units of 2^exponent.
template <Scalar R, int N, int E = N>
struct LocalCorners {
  std::array<Vec3<R>, N> corners;
  std::array<Vec3<R>, E> edges;
  int exponent = 0;

  /// False for an input that is not finite; the edges are differences of the corners as they were given.
  bool set(std::span<const Vec3<R>> given, const Vec3<R>& point) {
    using std::abs, std::frexp, std::isfinite;
    for (int k = 0; k < N; ++k) corners[k] = given[k] - point;
    for (int k = 0; k < E; ++k) edges[k] = given[(k + 1) % N] - given[k];
    R extent = 0;
    for (const Vec3<R>& corner : corners)
      for (int i = 0; i < 3; ++i) {
        if (!isfinite(corner[i])) return false;
        extent = std::max<R>(extent, abs(corner[i]));
      }
    for (const Vec3<R>& edge : edges)
      for (int i = 0; i < 3; ++i)
        if (!isfinite(edge[i])) return false;
    frexp(extent, &exponent);
    const PowerOfTwo<R> to_unit(-exponent);
    for (Vec3<R>& corner : corners) corner = {to_unit(corner[0]), to_unit(corner[1]), to_unit(corner[2])};
    for (Vec3<R>& edge : edges) edge = {to_unit(edge[0]), to_unit(edge[1]), to_unit(edge[2])};
    return true;
  }
};

/// Natural logarithm of the unit 2^exponent.
template <Scalar R>
R log_of_unit(int exponent) {
  if constexpr (is_multiprecision<R>) return exponent * MpConstants<std::numeric_limits<R>::digits10>::ln_two();
  else return static_cast<R>(exponent) * std::numbers::ln2_v<R>;
}

}  // namespace cageproof::quadrature_ref
