// SPDX-License-Identifier: MIT
#include "frame.h"

#include "exact_input.h"

namespace cageproof::quadrature_ref::certified {
namespace {

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator/(const Vector& a, const Real& s) { return {a[0] / s, a[1] / s, a[2] / s}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The exact numbers of a frame: sums and products of the coordinates, without rounding.
struct ExactTriangle {
  std::array<Vector, 3> corners, edges;              // x of the corners; corner k + 1 minus corner k
  Vector normal;                                     // twice the area long
  Real area_squared;                                 // normal . normal
  Real height;                                       // x . normal
  std::array<Real, 3> sides;                         // (corner k cross corner k + 1) . normal
  std::array<Real, 3> lengths_squared, first, last;  // first, last: corner . edge
};

template <Scalar R>
std::optional<ExactTriangle> exact_triangle(const Query<R>& query) {
  const auto input = exact_input<3>(query);
  if (!input) return std::nullopt;
  const ExactInput<3>& at = *input;
  const WorkingBits exact = WorkingBits::exact();
  ExactTriangle t;
  for (int k = 0; k < 3; ++k) {
    t.corners[k] = at[k] - at[3];
    t.edges[k] = at[(k + 1) % 3] - at[k];
  }
  t.normal = cross(t.edges[0], t.edges[1]);
  t.area_squared = dot(t.normal, t.normal);
  if (t.area_squared.is_zero()) return std::nullopt;
  t.height = dot(t.corners[0], t.normal);
  for (int k = 0; k < 3; ++k) {
    t.sides[k] = dot(cross(t.corners[k], t.corners[(k + 1) % 3]), t.normal);
    t.lengths_squared[k] = dot(t.edges[k], t.edges[k]);
    t.first[k] = dot(t.corners[k], t.edges[k]);
    t.last[k] = dot(t.corners[(k + 1) % 3], t.edges[k]);
  }
  return t;
}

bool nonnegative(const Real& exact) { return arb_is_nonnegative(exact.raw()) != 0; }

}  // namespace

template <Scalar R>
std::optional<Frame> frame_of(const Query<R>& query) {
  const auto exact = exact_triangle(query);
  if (!exact) return std::nullopt;
  const ExactTriangle& t = *exact;
  Frame s;
  const Real twice_area = sqrt(t.area_squared);
  s.axes[2] = t.normal / twice_area;
  s.axes[0] = t.edges[0] / sqrt(t.lengths_squared[0]);
  s.axes[1] = cross(s.axes[2], s.axes[0]);
  s.height = t.height / twice_area;
  s.in_plane = t.height.is_zero();
  s.on_triangle = s.in_plane;
  for (int k = 0; k < 3; ++k) {
    EdgeFrame& e = s.edges[k];
    const Real length = sqrt(t.lengths_squared[k]);
    e.passes = t.sides[k].is_zero();
    s.on_triangle = s.on_triangle && nonnegative(t.sides[k]);
    e.height = t.sides[k] / (twice_area * length);
    e.distance = sqrt(e.height * e.height + s.height * s.height);
    e.first = t.first[k] / length;
    e.last = t.last[k] / length;
    e.along = {dot(t.edges[k], s.axes[0]) / length, dot(t.edges[k], s.axes[1]) / length};
    e.outward = {e.along[1], -e.along[0]};
  }
  // Corner k's hat function at y: (edge k + 1 cross (y - corner k + 1)) over twice the area.
  for (int k = 0; k < 3; ++k) {
    const int opposite = (k + 1) % 3;
    const Vector& edge = t.edges[opposite];
    s.hat[k] = {t.sides[opposite] / t.area_squared, -dot(edge, s.axes[1]) / twice_area,
                dot(edge, s.axes[0]) / twice_area};
  }
  return s;
}

template std::optional<Frame> frame_of<float>(const Query<float>&);
template std::optional<Frame> frame_of<double>(const Query<double>&);
template std::optional<Frame> frame_of<Mp50>(const Query<Mp50>&);
template std::optional<Frame> frame_of<Mp100>(const Query<Mp100>&);
template std::optional<Frame> frame_of<Mp200>(const Query<Mp200>&);

}  // namespace cageproof::quadrature_ref::certified
