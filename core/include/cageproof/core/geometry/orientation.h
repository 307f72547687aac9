// SPDX-License-Identifier: MIT
// On which side of a segment's line, of a triangle's plane, and of its edges, a point lies, and how triangles are
// turned: decided exactly, for any finite doubles.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <span>

namespace cageproof {

/// In the plane: +1 on the side that the segment's normal points to (the right of s0 -> s1), -1 on the other, 0 exactly
/// on its line, for any finite doubles. Third coordinates are not looked at.
int side_of_line(const Segment<double>& s, const Vec3<double>& point);

/// +1 on the side that the triangle's normal points to, -1 on the other, 0 exactly in its plane: the sign of
/// ((t1 - t0) x (t2 - t0)) . (point - t0), for any finite doubles (CGAL's filtered exact predicates).
int side_of_plane(const Triangle<double>& t, const Vec3<double>& point);

/// Returns, for a point in the triangle's plane, +1 on the triangle's side of the line through corners `edge` and
/// `edge` + 1, -1 on its other side, and 0 on it or if the triangle has no area. \pre side_of_plane(t, point) == 0
int side_of_edge(const Triangle<double>& t, int edge, const Vec3<double>& point);

/// Whether the triangle has no area.
bool on_a_line(const Triangle<double>& t);

/// The sign of the product of two triangles' normals: -1 where they are turned by more than a right angle to each
/// other.
int sign_of_normals(const Triangle<double>& a, const Triangle<double>& b);

/// The sign of the product of triangle `a`'s normal with the sum of both normals, each as long as its triangle's area:
/// -1 where `a` is turned against the surface that both make.
int sign_with_both_normals(const Triangle<double>& a, const Triangle<double>& b);

/// The sign of the volume that closed triangles enclose, positive where their normals point outward: of the sum of
/// (t0 - o) . ((t1 - o) x (t2 - o)), o any point.
int sign_of_volume(std::span<const Triangle<double>> triangles);

}  // namespace cageproof
