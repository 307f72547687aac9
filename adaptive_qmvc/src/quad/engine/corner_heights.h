// SPDX-License-Identifier: MIT
// Heights of a point over the planes of a quad's corners: N.x is bilinear, and has them at the corners.
#pragma once

#include "cageproof/closed_form/arithmetic/double_double.h"
#include "cageproof/core/geometry/exact_volume.h"
#include "cageproof/core/numbers/linear.h"

#include <cmath>

namespace cageproof::adaptive_qmvc {

/// (corner - before) x (after - corner) . (corner - point) in units of 2^(3 exponent), to two roundings whatever
/// cancels: in twice the digits, and exactly where these are too few.
inline double height_at_corner(const Vec3<double>& before, const Vec3<double>& corner, const Vec3<double>& after,
                               const Vec3<double>& point, int exponent) {
  using Wide = closed_form::DoubleDouble;
  // Of 100 bits 56 are left; below the second products lose bits to the end of the range.
  constexpr double kCancelled = 0x1p-44, kSmallest = 0x1p-800;
  const double unit = std::ldexp(1, -exponent);
  const auto difference = [&](const Vec3<double>& to, const Vec3<double>& from, int i) {
    const Wide exact = Wide::sum(to[i], -from[i]);
    return Wide(exact.high * unit, exact.low * unit);
  };
  Wide p[3], q[3], x[3];
  for (int i = 0; i < 3; ++i) {
    p[i] = difference(corner, before, i);
    q[i] = difference(after, corner, i);
    x[i] = difference(corner, point, i);
  }
  Wide sum = 0;
  double terms = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += x[i] * (p[j] * q[k] - p[k] * q[j]);
    terms += std::abs(x[i].high) * (std::abs(p[j].high * q[k].high) + std::abs(p[k].high * q[j].high));
  }
  if (terms > kSmallest && std::abs(sum.high) > kCancelled * terms) return static_cast<double>(sum);
  return exact_volume({before, corner, after}, point, exponent);
}

}  // namespace cageproof::adaptive_qmvc
