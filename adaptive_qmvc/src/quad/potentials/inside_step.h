// SPDX-License-Identifier: MIT
// Decides whether a point is on a quad, which limits exist there, and at which points next to it limits from inside are
// computed.
#pragma once

#include "quad/mean_value/line_form/line_form.h"
#include "quad/potentials/kernel_terms.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace cageproof::adaptive_qmvc {

/// The result of step_inside().
struct InsideStep {
  Vec3<Mp200> point;    ///< against the normal, so near that what is missing of a limit is below a double's rounding
  bool border = false;  ///< whether the point lies on a side
  bool tiny = false;    ///< whether the step needs more than 100 digits
  bool exists = true;   ///< false where the normal vanishes, or where 200 digits do not hold the step
};

/// Whether a point is on a side, exactly as far as 800 digits hold the products of coordinates.
inline bool lies_on_side(const Vec3<Mp200>& from, const Vec3<Mp200>& to, const Vec3<Mp200>& point) {
  const Vec3<Mp800> eta = point.template cast<Mp800>();
  const Vec3<Mp800> a = from.template cast<Mp800>() - eta, b = to.template cast<Mp800>() - eta, area = a.cross(b);
  return area[0] == 0 && area[1] == 0 && area[2] == 0 && a.dot(b) <= 0;
}

/// The point next to `on`, where `point` lies on the quad.
/// \param for_multiprecision whether a limit is wanted to some 35 digits, not to a double's
template <Scalar R>
InsideStep step_inside(std::span<const Vec3<R>> corners, const Vec3<R>& point, const BilinearPoint& on,
                       bool for_multiprecision) {
  using W = Mp200;
  std::array<Vec3<W>, 4> x;
  for (int k = 0; k < 4; ++k) x[k] = convert<W>(corners[k]);
  const Vec3<W> eta = convert<W>(point);
  // Rounded parameters: the normal turns by no more.
  const W u = on.u, v = on.v;
  const Vec3<W> along = (1 - v) * (x[1] - x[0]) + v * (x[2] - x[3]);
  const Vec3<W> across = (1 - u) * (x[3] - x[0]) + u * (x[2] - x[1]);
  const Vec3<W> normal = along.cross(across);
  InsideStep step;
  W nearest = std::numeric_limits<W>::infinity(), size = 0;  // the nearest of the sides that the point is not on
  for (int k = 0; k < 4; ++k) {
    const Vec3<W> side = x[(k + 1) % 4] - x[k], to = eta - x[k];
    const W square = side.dot(side);
    const W t = square > W(0) ? std::clamp(W(to.dot(side) / square), W(0), W(1)) : W(0);
    const Vec3<W> off = to - t * side;
    // t is rounded: whether the point is on the side is not asked of what is left.
    if (lies_on_side(x[k], x[(k + 1) % 4], eta)) step.border = true;
    else nearest = std::min(nearest, W(sqrt(W(off.dot(off)))));
    size = std::max(size, W(sqrt(square)));
  }
  const W length = sqrt(W(normal.dot(normal)));
  step.exists = length > W(0);
  if (!step.exists) return step;
  // In the distance to other sides what is missing is that much; on a side, times its logarithm.
  int bits = for_multiprecision ? (step.border ? 140 : 120) : (step.border ? 80 : 70);
  // Over a quad that is all but flat, what is sought is as small as its twist.
  const W twist = abs(W((x[2] - x[0]).dot((x[1] - x[0]).cross(x[3] - x[0])))) / length;
  constexpr int most_for_twist = 64;
  if (twist > W(0) && twist < nearest)
    bits += std::min(most_for_twist, static_cast<int>(-std::log2(static_cast<double>(W(twist / nearest)))));
  const W height = ldexp(nearest, -bits);
  step.tiny = height < ldexp(size, -100);
  step.point = eta - (height / length) * normal;
  step.exists = step.point != eta;
  return step;
}

/// Whether a potential's derivatives of an order stay finite on the quad's border, coming from inside against the
/// normal there. The double layer's value depends on the direction of approach, and is taken so too, as a triangle's
/// is.
inline bool has_border_limit(Potential potential, int order) {
  switch (potential) {
    case Potential::SingleLayer:
    case Potential::DoubleLayer:
    case Potential::KelvinDisplacement: return order == 0;
    case Potential::BiharmonicSingleLayer: return true;
    case Potential::BiharmonicDoubleLayer: return order <= 1;
    default: return false;
  }
}

/// Whether the quad and a point on it lie in one plane, exactly as far as 800 digits hold the products of coordinates.
template <Scalar R>
bool is_in_plane(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  const auto from_point = [&](int k) {
    return Vec3<Mp800>(convert<Mp200>(corners[k % 4]).template cast<Mp800>() -
                       convert<Mp200>(point).template cast<Mp800>());
  };
  for (int k = 0; k < 4; ++k)
    if (from_point(k).dot(from_point(k + 1).cross(from_point(k + 3))) != 0) return false;
  return true;
}

}  // namespace cageproof::adaptive_qmvc
