// SPDX-License-Identifier: MIT
#include "cageproof/core/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace cageproof {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 as_point(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

int side_of_line(const Segment<double>& s, const Vec3<double>& point) {
  const auto in_plane = [](const Vec3<double>& v) { return Kernel::Point_2(v[0], v[1]); };
  // CGAL's positive side is the left one.
  return -static_cast<int>(CGAL::orientation(in_plane(s[0]), in_plane(s[1]), in_plane(point)));
}

int side_of_plane(const Triangle<double>& t, const Vec3<double>& point) {
  return static_cast<int>(CGAL::orientation(as_point(t[0]), as_point(t[1]), as_point(t[2]), as_point(point)));
}

int side_of_edge(const Triangle<double>& t, int edge, const Vec3<double>& point) {
  const auto from = as_point(t[edge]), to = as_point(t[(edge + 1) % 3]), opposite = as_point(t[(edge + 2) % 3]);
  // CGAL asks for a third corner off the edge's line.
  if (CGAL::collinear(from, to, opposite)) return 0;
  return static_cast<int>(CGAL::coplanar_orientation(from, to, opposite, as_point(point)));
}

}  // namespace cageproof
