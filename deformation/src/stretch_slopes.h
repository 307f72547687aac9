// SPDX-License-Identifier: MIT
// Gradients by posed tangents of how much an element is stretched.
#pragma once

#include "stretched_squares.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// A number, and its gradients by the two posed tangents.
template <Scalar R>
struct BySides {
  R value = 0;
  std::array<Vec3<R>, 2> slopes = {Vec3<R>::Zero(), Vec3<R>::Zero()};
};

/// |u x v|. \pre not zero
template <Scalar R>
BySides<R> area_slopes(const std::array<Vec3<R>, 2>& posed) {
  using std::sqrt;
  const Vec3<R> across = posed[0].cross(posed[1]);
  const R area = sqrt(R(across.dot(across)));
  const Vec3<R> unit = across / area;
  return {area, {posed[1].cross(unit), unit.cross(posed[0])}};
}

/// stretched_squares().
template <Scalar R>
BySides<R> squares_slopes(const std::array<Vec3<R>, 2>& rest, const std::array<Vec3<R>, 2>& posed, const R& area) {
  using std::sqrt;
  const R squares[2] = {rest[0].dot(rest[0]), rest[1].dot(rest[1])};
  const int first = squares[1] > squares[0] ? 1 : 0, other = 1 - first;
  BySides<R> found;
  found.value = stretched_squares(rest, posed, area);
  if (!(squares[first] > 0)) return found;
  const R length = sqrt(squares[first]), along = rest[0].dot(rest[1]) / length, across = area / length;
  const Vec3<R> of_other = length * posed[other] - along * posed[first];
  found.slopes[other] = 2 * length * of_other;
  found.slopes[first] = 2 * across * across * posed[first] - 2 * along * of_other;
  return found;
}

/// The stretch times the rest area: sqrt(squares/2), sqrt(squares + 2 area |N'|)/2, sqrt(area |N'|), area, or |N'|.
/// \param turned area_slopes(posed) \pre where the root is of zero there is no gradient, and it is NaN
template <Scalar R>
BySides<R> stretched_area_slopes(Stretch stretch, const std::array<Vec3<R>, 2>& rest,
                                 const std::array<Vec3<R>, 2>& posed, const R& area, const BySides<R>& turned) {
  using std::sqrt;
  if (stretch == Stretch::Unit) return {area, {Vec3<R>::Zero(), Vec3<R>::Zero()}};
  if (stretch == Stretch::Product) return turned;
  BySides<R> under_root;
  if (stretch == Stretch::Area) {
    under_root.value = area * turned.value;
    for (int k = 0; k < 2; ++k) under_root.slopes[k] = area * turned.slopes[k];
  } else {
    under_root = squares_slopes(rest, posed, area);
    const R share = stretch == Stretch::Rms ? R(0.5) : R(0.25);
    under_root.value *= share;
    for (Vec3<R>& slope : under_root.slopes) slope *= share;
    if (stretch == Stretch::Mean) {
      under_root.value += area * turned.value / 2;
      for (int k = 0; k < 2; ++k) under_root.slopes[k] += area / 2 * turned.slopes[k];
    }
  }
  BySides<R> found;
  found.value = sqrt(under_root.value);
  for (int k = 0; k < 2; ++k) found.slopes[k] = under_root.slopes[k] / (2 * found.value);
  return found;
}

/// The derivative of the unit vector along u x v, by u and by v: 3 x 3 each. \pre the product is not zero
template <Scalar R>
std::array<Mat3<R>, 2> unit_normal_slopes(const std::array<Vec3<R>, 2>& posed) {
  using std::sqrt;
  const Vec3<R> across = posed[0].cross(posed[1]);
  const R area = sqrt(R(across.dot(across)));
  const Vec3<R> unit = across / area;
  std::array<Mat3<R>, 2> found;
  for (int c = 0; c < 3; ++c) {
    Vec3<R> axis = Vec3<R>::Zero();
    axis[c] = 1;
    const Vec3<R> by_u = axis.cross(posed[1]), by_v = posed[0].cross(axis);
    found[0].col(c) = (by_u - unit * unit.dot(by_u)) / area;
    found[1].col(c) = (by_v - unit * unit.dot(by_v)) / area;
  }
  return found;
}

}  // namespace cageproof::deformation
