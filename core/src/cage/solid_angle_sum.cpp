// SPDX-License-Identifier: MIT
#include "solid_angle_sum.h"

#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/numbers/mp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

// Roundings of the sine and the cosine, in units of P = |a||b||c|, if each operation loses a unit: a, b, c are off by
// one unit per component, products of three components by 8 of their sizes, which add up to at most 2 P; lengths are
// off by 4, so that P is by 14, and each dot product times a length by 10; sums add the rest.
constexpr double kAcross = 18, kAlong = 60;
// An angle in double that may be off by more is taken in 50 digits.
constexpr double kEnough = 1e-13;

template <class R>
R dot(const std::array<R, 3>& a, const std::array<R, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Angle {
  double value, bound;
};

// \param scale a power of two that keeps squares and products of three lengths within the range \param side of the
// triangle's plane, asked for where the sine's sign is not certain
template <class R, class Side>
Angle angle_of(const Triangle<double>& t, const Vec3<double>& point, double scale, double unit, const Side& side) {
  using std::sqrt, std::atan2, std::abs;
  std::array<std::array<R, 3>, 3> x;
  std::array<R, 3> r;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) x[k][c] = R(scale * t[k][c]) - R(scale * point[c]);
    r[k] = sqrt(dot(x[k], x[k]));
  }
  const auto& [a, b, c] = x;
  const std::array<R, 3> cross{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
  const R size = r[0] * r[1] * r[2];
  R across = dot(a, cross);
  const R along = size + dot(a, b) * r[2] + dot(b, c) * r[0] + dot(c, a) * r[1];
  const R off_across = kAcross * unit * size, off_along = kAlong * unit * size;
  // Where the cosine may be negative, a sine of the wrong sign would be a whole turn.
  if (along < off_along && abs(across) <= off_across) {
    const int towards = -side();
    if (towards == 0) return {0, 0};
    across = towards > 0 ? abs(across) : -abs(across);
  }
  const R left = sqrt(across * across + along * along) - (off_across + off_along);
  const double value = static_cast<double>(2 * atan2(across, along));
  constexpr double rounding = std::numeric_limits<double>::epsilon(), most = 2 * 6.2831853071795862;
  if (!(left > off_across + off_along)) return {value, most};
  // The arc sine of a number of at most 1/2 is less than 1.1 times it.
  return {value, 2.2 * static_cast<double>((off_across + off_along) / left) + rounding * std::abs(value)};
}

}  // namespace

BoundedSum solid_angles(std::span<const Triangle<double>> triangles, const Vec3<double>& point) {
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  double largest = point.cwiseAbs().maxCoeff();
  for (const Triangle<double>& t : triangles)
    for (const Vec3<double>& corner : t) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  const double scale = largest > 0 ? std::ldexp(1, std::min(-std::ilogb(largest) - 1, 1000)) : 1;
  BoundedSum sum;
  for (const Triangle<double>& t : triangles) {
    const auto side = [&] { return side_of_plane(t, point); };
    Angle angle = angle_of<double>(t, point, scale, unit, side);
    if (!(angle.bound <= kEnough)) angle = angle_of<Mp50>(t, point, scale, std::ldexp(1, 1 - Mp50::bits), side);
    sum.value += angle.value;
    sum.bound += angle.bound + unit * std::abs(sum.value);
  }
  // Covers the bound's own roundings.
  sum.bound *= 1 + 1e-6;
  return sum;
}

}  // namespace cageproof
