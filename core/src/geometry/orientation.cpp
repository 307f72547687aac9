// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/orientation.h"

#include "exact_signs.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>

namespace cageproof {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 as_point(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }

// The sign of a number that sums, differences and products make of doubles: in intervals, and only where these do not
// tell it, in rationals. \param number called with the type to compute in
template <class Number>
int exact_sign(const Number& number) {
  {
    const CGAL::Protect_FPU_rounding<true> rounds_upward;
    const CGAL::Interval_nt<false> within = number.template operator()<CGAL::Interval_nt<false>>();
    if (within.inf() > 0) return 1;
    if (within.sup() < 0) return -1;
    if (within.inf() == 0 && within.sup() == 0) return 0;
  }
  return exact::sign(number.template operator()<exact::Rational>());
}

template <class T>
std::array<T, 3> difference(const Vec3<double>& a, const Vec3<double>& b) {
  return {T(a[0]) - T(b[0]), T(a[1]) - T(b[1]), T(a[2]) - T(b[2])};
}
template <class T>
std::array<T, 3> vector_product(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
T scalar_product(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
std::array<T, 3> normal_of(const Triangle<double>& t) {
  return vector_product(difference<T>(t[1], t[0]), difference<T>(t[2], t[0]));
}

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

bool on_a_line(const Triangle<double>& t) { return CGAL::collinear(as_point(t[0]), as_point(t[1]), as_point(t[2])); }

int sign_of_normals(const Triangle<double>& a, const Triangle<double>& b) {
  return exact_sign([&]<class T>() { return scalar_product(normal_of<T>(a), normal_of<T>(b)); });
}

int sign_with_both_normals(const Triangle<double>& a, const Triangle<double>& b) {
  return exact_sign([&]<class T>() {
    const std::array<T, 3> own = normal_of<T>(a);
    return scalar_product(own, own) + scalar_product(own, normal_of<T>(b));
  });
}

int sign_of_volume(std::span<const Triangle<double>> triangles) {
  if (triangles.empty()) return 0;
  const Vec3<double>& origin = triangles.front()[0];
  return exact_sign([&]<class T>() {
    T sum(0);
    for (const Triangle<double>& t : triangles)
      sum += scalar_product(difference<T>(t[0], origin),
                            vector_product(difference<T>(t[1], origin), difference<T>(t[2], origin)));
    return sum;
  });
}

}  // namespace cageproof
