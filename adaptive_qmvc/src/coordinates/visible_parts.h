// SPDX-License-Identifier: MIT
// The parts of a face's triangle that a point sees past other triangles: convex polygons in the triangle's plane.
#pragma once

#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/numbers/scalar.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// A convex polygon by its corners, relative to the point.
template <Scalar R>
using SeenPolygon = std::vector<Vec3<R>>;

/// A triangle as the point sees it.
template <Scalar R>
struct SeenTriangle {
  std::array<int, 3> vertices;
  std::array<Vec3<R>, 3> p;     ///< corners relative to the point
  std::array<Vec3<R>, 3> side;  ///< p_k x p_{k+1}: the planes through the point, inward where `volume` is positive
  Vec3<R> normal;               ///< of twice the area
  R volume;                     ///< normal.p_0, positive where the point looks along the normal

  SeenTriangle(const std::array<int, 3>& v, const std::array<Vec3<R>, 3>& corners) : vertices(v), p(corners) {
    for (int k = 0; k < 3; ++k) side[k] = p[k].cross(p[(k + 1) % 3]);
    normal = (p[1] - p[0]).cross(p[2] - p[0]);
    volume = normal.dot(p[0]);
  }
};

/// Cuts a polygon by a plane through the point; a part without extent is empty.
template <Scalar R>
void cut(const SeenPolygon<R>& polygon, const Vec3<R>& normal, SeenPolygon<R>& inside, SeenPolygon<R>& outside) {
  inside.clear();
  outside.clear();
  bool any_inside = false, any_outside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3<R>&here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const R a = normal.dot(here), b = normal.dot(next);
    any_inside = any_inside || a > 0;
    any_outside = any_outside || a < 0;
    if (a >= 0) inside.push_back(here);
    if (a <= 0) outside.push_back(here);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
      const Vec3<R> crossing = here + R(a / (a - b)) * (next - here);
      inside.push_back(crossing);
      outside.push_back(crossing);
    }
  }
  if (!any_inside) inside.clear();
  if (!any_outside) outside.clear();
}

/// Twice the area of a convex polygon.
template <Scalar R>
R area_of(const SeenPolygon<R>& polygon) {
  Vec3<R> sum = Vec3<R>::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return sum.norm();
}

/// Whether `u` lies before the plane of a polygon, in whose direction it is seen. Triangles that do not cross each
/// other lie one before the other in all directions, since some plane is between them.
template <Scalar R>
bool hides(const SeenTriangle<R>& u, const SeenPolygon<R>& polygon) {
  Vec3<R> middle = Vec3<R>::Zero();
  for (const Vec3<R>& corner : polygon) middle += corner;
  middle /= R(static_cast<double>(polygon.size()));
  return u.volume < u.normal.dot(middle);
}

/// Takes what `u` hides from the parts of a triangle that are visible so far. \param size twice the triangle's area
template <Scalar R>
void take_hidden(const SeenTriangle<R>& u, const R& size, std::vector<SeenPolygon<R>>& visible) {
  // Where edges are shared, roundings leave slivers, which hide nothing.
  const R least = size * std::numeric_limits<R>::epsilon() * R(1024);
  std::vector<SeenPolygon<R>> left;
  SeenPolygon<R> common, outside, inside;
  for (SeenPolygon<R>& part : visible) {
    std::vector<SeenPolygon<R>> beside;
    common = part;
    for (int k = 0; k < 3 && !common.empty(); ++k) {
      cut(common, u.side[k], inside, outside);
      if (!outside.empty()) beside.push_back(outside);
      std::swap(common, inside);
    }
    if (common.size() < 3 || area_of(common) <= least || !hides(u, common)) left.push_back(std::move(part));
    else std::ranges::move(beside, std::back_inserter(left));
  }
  visible = std::move(left);
}

/// The integral of unit vectors over the solid angle of a polygon whose sides' planes are inward ([T18] Eq 13, 16).
template <Scalar R>
Vec3<R> mean_vector_of(const SeenPolygon<R>& polygon) {
  using std::atan2;
  Vec3<R> sum = Vec3<R>::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3<R>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Vec3<R> n = a.cross(b);
    const R sine = n.norm();
    if (sine > 0) sum += n * R(atan2(sine, R(a.dot(b))) / (2 * sine));
  }
  return sum;
}

}  // namespace cageproof::adaptive_qmvc
