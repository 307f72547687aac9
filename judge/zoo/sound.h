// SPDX-License-Identifier: MIT
// Shared by the zoo's members: the sound form at one point, and where the point lies.
#pragma once

#include "zoo.h"

#include <array>
#include <cmath>

namespace cageproof::zoo {

using Point = std::array<double, 3>;

inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Point corner(const zoo_call& call, int k) {
  return {call.corners[3 * k], call.corners[3 * k + 1], call.corners[3 * k + 2]};
}
inline Point point(const zoo_call& call, std::size_t p) {
  return {call.points[3 * p], call.points[3 * p + 1], call.points[3 * p + 2]};
}
inline int corners(const zoo_call& call) { return zoo_dimension(call.formula); }
inline int components(const zoo_call& call) { return zoo_components(call.formula); }
inline double* values(const zoo_call& call, std::size_t p) {
  return call.values + p * static_cast<std::size_t>(components(call));
}
/// Null for order 0.
inline double* gradients(const zoo_call& call, std::size_t p) {
  if (call.order < 1) return nullptr;
  return call.gradients + p * static_cast<std::size_t>(components(call) * corners(call));
}

/// Calls `f` for each number of a point's value and gradient.
template <class F>
void for_each_number(const zoo_call& call, std::size_t p, F&& f) {
  const int count = components(call), dim = corners(call);
  for (int c = 0; c < count; ++c) f(values(call, p)[c]);
  for (int c = 0; c < count * dim && call.order > 0; ++c) f(gradients(call, p)[c]);
}

/// Whether a point is an element's corner, exactly.
inline bool is_corner(const zoo_call& call, std::size_t p) {
  for (int k = 0; k < corners(call); ++k)
    if (point(call, p) == corner(call, k)) return true;
  return false;
}

/// A triangle's plane, edges and the point's place in them.
struct Place {
  double volume = 0;            ///< (b - a) x (c - a) . (p - a)
  double area = 0;              ///< |(b - a) x (c - a)|
  double size = 0;              ///< longest edge
  double height = 0;            ///< signed distance from the plane
  std::array<double, 3> hat{};  ///< hat functions of the foot
  bool in_plane = false, inside = false, on_border = false;
};
inline Place place_of(const zoo_call& call, std::size_t p) {
  const Point a = corner(call, 0), ab = corner(call, 1) - a, ac = corner(call, 2) - a, ap = point(call, p) - a;
  const Point normal = cross(ab, ac);
  Place at;
  at.volume = dot(normal, ap);
  at.area = norm(normal);
  at.size = std::fmax(norm(ab), std::fmax(norm(ac), norm(ac - ab)));
  at.height = at.volume / at.area;
  at.hat[1] = dot(cross(ap, ac), normal) / (at.area * at.area);
  at.hat[2] = dot(cross(ab, ap), normal) / (at.area * at.area);
  at.hat[0] =
      dot(cross(corner(call, 1) - point(call, p), corner(call, 2) - point(call, p)), normal) / (at.area * at.area);
  at.in_plane = at.volume == 0;
  at.inside = at.hat[0] > 0 && at.hat[1] > 0 && at.hat[2] > 0;
  at.on_border = at.in_plane && !at.inside && at.hat[0] >= 0 && at.hat[1] >= 0 && at.hat[2] >= 0;
  return at;
}

}  // namespace cageproof::zoo
