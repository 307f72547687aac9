// SPDX-License-Identifier: MIT
// Vectors of exact numbers, with sums and products only. T is a number type that is exact for the input.
#pragma once

#include "../certified/ball.h"

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <span>

namespace cageproof::quadrature_ref {

template <class T>
using ExactVector = std::array<T, 3>;

template <class T>
ExactVector<T> minus(const ExactVector<T>& a, const ExactVector<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
T scalar_product(const ExactVector<T>& a, const ExactVector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
ExactVector<T> vector_product(const ExactVector<T>& a, const ExactVector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The first N corners as the point sees them: corner minus point.
template <class T, std::size_t N>
std::array<ExactVector<T>, N> seen(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point) {
  const auto exactly = [](const Mp200& x) {
    if constexpr (std::same_as<T, certified::Real>) return certified::Real::exactly(x);
    else return x;
  };
  std::array<ExactVector<T>, N> x;
  for (std::size_t k = 0; k < N; ++k)
    for (int i = 0; i < 3; ++i) x[k][i] = exactly(corners[k][i]) - exactly(point[i]);
  return x;
}

}  // namespace cageproof::quadrature_ref
