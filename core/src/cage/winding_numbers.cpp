// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/winding_numbers.h"

#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>

namespace cageproof {
namespace {

using Pair = std::array<Triangle<double>, 2>;

// Triangles without area, as a quad with corners on a line has, have edges that others have, too.
bool touches_triangle(const Triangle<double>& t, const Vec3<double>& point) {
  if (side_of_plane(t, point) != 0 || on_a_line(t)) return false;
  for (int edge = 0; edge < 3; ++edge)
    if (side_of_edge(t, edge, point) < 0) return false;
  return true;
}

// Two triangles with the quad's border that the point sees under the quad's own solid angle. \pre the point is not on
// the quad
Pair seen_as(const Quad<double>& q, const Vec3<double>& point) {
  Pair first{Triangle<double>{q[0], q[1], q[2]}, {q[0], q[2], q[3]}},
      second{Triangle<double>{q[1], q[2], q[3]}, {q[1], q[3], q[0]}};
  switch (seen_triangles(q, point)) {
    case SeenTriangles::Diagonal02: return first;
    case SeenTriangles::Diagonal13: return second;
    case SeenTriangles::Coplanar: break;
  }
  // Off the triangles that the point lies in the plane of, both pairs are the same to it; on one of them, the quad is
  // on the other pair's side.
  return touches_triangle(first[0], point) || touches_triangle(first[1], point) ? second : first;
}

int sign(double x) { return (x > 0) - (x < 0); }

// The turn at b of the path a, b, point, seen from above: +1 to the left. The point counts as moved by e along the
// first axis and by e^2 along the second, e less than any number.
int turn(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& point) {
  if (const int right = side_of_line({a, b}, point); right != 0) return -right;
  return b[1] != a[1] ? -sign(b[1] - a[1]) : sign(b[0] - a[0]);
}

// The signed crossing of a ray upward. Nothing for a point on the triangle.
std::optional<int> crossing_above(const Triangle<double>& t, const Vec3<double>& point) {
  // Below all corners a point is on no triangle, and under every one that its ray meets.
  const bool is_below = point[2] < std::min({t[0][2], t[1][2], t[2][2]});
  const int side = is_below ? 0 : side_of_plane(t, point);
  if (side == 0 && !is_below) return touches_triangle(t, point) ? std::nullopt : std::optional(0);
  const int turned = turn(t[0], t[1], point);
  if (turned == 0 || turn(t[1], t[2], point) != turned || turn(t[2], t[0], point) != turned) return 0;
  return is_below || side == -turned ? turned : 0;
}

// The signed crossing of a segment in the plane by a ray along the second axis. Nothing for a point on the segment.
std::optional<int> crossing_above(const Segment<double>& s, const Vec3<double>& point) {
  const int right = side_of_line(s, point);
  const Vec3<double> low = s[0].cwiseMin(s[1]), high = s[0].cwiseMax(s[1]);
  if (right == 0 && low[0] <= point[0] && point[0] <= high[0] && low[1] <= point[1] && point[1] <= high[1])
    return std::nullopt;
  const bool to_left = s[1][0] <= point[0], from_left = s[0][0] <= point[0];
  if (to_left == from_left) return 0;
  // Counter-clockwise boundaries run to the left above what they hold, and have it on their left.
  if (to_left) return right < 0 ? 1 : 0;
  return right > 0 ? -1 : 0;
}

std::optional<int> crossing_above(std::span<const Vec3<double>> c, const Vec3<double>& point) {
  if (c.size() == 2) return crossing_above(Segment<double>{c[0], c[1]}, point);
  if (c.size() == 3) return crossing_above(Triangle<double>{c[0], c[1], c[2]}, point);
  const Quad<double> q{c[0], c[1], c[2], c[3]};
  if (on_quad(q, point)) return std::nullopt;
  int sum = 0;
  for (const Triangle<double>& t : seen_as(q, point)) {
    const auto found = crossing_above(t, point);
    if (!found) return std::nullopt;
    sum += *found;
  }
  return sum;
}

// With these axes first and second the cage is seen along its least extent: fewest elements lie above each other.
int first_axis_of(const CageElements& elements) {
  if (elements.dimension() == 2) return 0;
  const auto [low, high] = box_of(elements.vertices());
  int least = 2;
  for (int axis = 0; axis < 2; ++axis)
    if (high[axis] / 2 - low[axis] / 2 < high[least] / 2 - low[least] / 2) least = axis;
  return (least + 1) % 3;
}

Vec3<double> turned(const Vec3<double>& v, int first) { return {v[first], v[(first + 1) % 3], v[(first + 2) % 3]}; }

std::vector<std::vector<Vec3<double>>> turned_corners(const CageElements& elements, int first) {
  std::vector<std::vector<Vec3<double>>> all;
  all.reserve(elements.count());
  for (std::size_t e = 0; e < elements.count(); ++e) {
    all.push_back(elements.corners(e));
    for (Vec3<double>& corner : all.back()) corner = turned(corner, first);
  }
  return all;
}

}  // namespace

WindingNumbers::WindingNumbers(const CageElements& elements)
    : first_axis_(first_axis_of(elements)),
      top_(box_of(elements.vertices()).high[elements.dimension() == 2 ? 1 : (first_axis_ + 2) % 3]),
      elements_(turned_corners(elements, first_axis_)),
      tree_(boxes_of(elements_)) {}

std::optional<int> WindingNumbers::around(const Vec3<double>& given) const {
  const Vec3<double> point = turned(given, first_axis_);
  const int up = elements_.front().size() == 2 ? 1 : 2;
  Box above{point, point};
  above.high[up] = std::max(above.high[up], top_);
  std::optional<int> winding = 0;
  tree_.for_each_meeting(above, [&](int e) {
    const auto crossing = crossing_above(elements_[e], point);
    if (!crossing) winding.reset();
    else *winding += *crossing;
    return winding.has_value();
  });
  return winding;
}

}  // namespace cageproof
