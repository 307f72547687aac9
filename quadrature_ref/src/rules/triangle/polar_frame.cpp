// SPDX-License-Identifier: MIT
#include "polar_frame.h"

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

using R = Mp200;

bool projects_inside(const std::array<EdgeLine, 3>& lines) {
  return std::ranges::all_of(lines, [](const EdgeLine& line) { return line.inside >= 0; });
}

struct Nearest {
  Vec3<R> x;                      ///< c - eta
  std::array<bool, 3> on_edge{};  ///< c lies on that edge
};

Nearest nearest_point(const LinedTriangle& t) {
  const auto& lines = t.lines;
  Nearest best;
  if (projects_inside(lines)) {
    best.x = t.normal * t.height;
    for (int k = 0; k < 3; ++k) best.on_edge[k] = lines[k].inside == 0;
    return best;
  }
  R best_square = -1;
  for (int k = 0; k < 3; ++k) {
    const R s = -dot(t.corners[k], lines[k].u);
    Nearest candidate;
    candidate.on_edge[k] = true;
    if (s <= 0) {
      candidate.x = t.corners[k];
      candidate.on_edge[(k + 2) % 3] = true;
    } else if (s >= lines[k].length) {
      candidate.x = t.corners[(k + 1) % 3];
      candidate.on_edge[(k + 1) % 3] = true;
    } else {
      candidate.x = t.corners[k] + lines[k].u * s;
    }
    const R square = dot(candidate.x, candidate.x);
    if (best_square < 0 || square < best_square) {
      best_square = square;
      best = candidate;
    }
  }
  return best;
}

// The integrand is singular in v where the ray's foot (cosh v = 0) or r at the edge vanishes, and where w at the edge,
// asinh of a cosh v / distance, has its branch points.
Singularities singular_points(const R& a, const R& distance, const R& along, const R& line_distance, double v0) {
  using Complex = std::complex<double>;
  constexpr double kHalfPi = std::numbers::pi / 2;
  const double branch = std::asinh(static_cast<double>(distance / a));
  Singularities points{Complex(-v0, kHalfPi), Complex(branch - v0, kHalfPi), Complex(-branch - v0, kHalfPi)};
  const Complex edge_zero(static_cast<double>(along / a), static_cast<double>(line_distance / a));
  if (std::isfinite(std::norm(edge_zero))) {
    // sinh takes each value twice in the strip 0 < Im v < pi.
    const Complex v = std::asinh(edge_zero);
    points.push_back(v - v0);
    points.push_back(Complex(-v.real() - v0, std::numbers::pi - v.imag()));
  }
  return points;
}

}  // namespace

std::optional<LinedTriangle> lined_triangle(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  const auto frame = triangle_frame(corners, point);
  if (!frame) return std::nullopt;
  LinedTriangle t{*frame, {}};
  const Vec3<R> area_vector = t.edges[0].cross(t.edges[1]);
  for (int k = 0; k < 3; ++k) {
    EdgeLine& line = t.lines[k];
    line.length = length(t.edges[k]);
    line.u = t.edges[k] / line.length;
    line.nu = line.u.cross(t.normal);
    // Divided last: products of doubles are exact here, so that a point on the edge's line gives exactly zero.
    const Vec3<R> across = t.edges[k].cross(area_vector);
    line.inside = dot(across, t.corners[k]) / (line.length * t.twice_area);
  }
  return t;
}

OnTriangle on_triangle(const LinedTriangle& t) {
  const auto& lines = t.lines;
  if (t.height != 0 || !projects_inside(lines)) return {};
  OnTriangle result{.yes = true};
  const auto consider = [&](const R& distance) {
    if (distance > 0 && (result.clearance == 0 || distance < result.clearance)) result.clearance = distance;
  };
  for (int k = 0; k < 3; ++k) {
    if (lines[k].inside == 0) result.border = true;
    consider(lines[k].inside);
    consider(length(t.corners[k]));
  }
  return result;
}

PolarFrame<R> polar_frame(const LinedTriangle& t, const R& inward) {
  const auto& lines = t.lines;
  const Nearest nearest = nearest_point(t);
  PolarFrame<R> frame;
  frame.base = nearest.x + t.normal * inward;
  frame.normal = t.normal;
  frame.height = t.height + inward;
  frame.distance = length(frame.base);
  frame.interior = std::ranges::none_of(nearest.on_edge, std::identity{});
  frame.exponent = t.exponent;
  frame.along = lines[0].u;
  frame.across = lines[0].nu;
  for (int k = 0; k < 3; ++k) {
    const int opposite = (k + 2) % 3;  // its hat function vanishes on edge k
    const R steepness = lines[k].length / t.twice_area;
    const R to_line = dot(lines[k].nu, Vec3<R>(t.corners[k] - nearest.x));
    frame.hat[opposite] = nearest.on_edge[k] ? R(0) : R(to_line * steepness);
    frame.slope_along[opposite] = -dot(lines[k].nu, frame.along) * steepness;
    frame.slope_across[opposite] = -dot(lines[k].nu, frame.across) * steepness;
  }
  for (int k = 0; k < 3; ++k) {
    if (nearest.on_edge[k]) continue;
    const EdgeLine& line = lines[k];
    const Vec3<R> to_start = t.corners[k] - nearest.x;
    PolarEdge<R> edge;
    edge.nu = line.nu;
    edge.u = line.u;
    edge.a = dot(line.nu, to_start);
    if (!(edge.a > 0)) continue;
    const R s0 = dot(line.u, to_start);
    edge.v0 = inverse_sinh(R(s0 / edge.a));
    edge.v_length = inverse_sinh(R((s0 + line.length) / edge.a)) - edge.v0;
    edge.start = k;
    edge.reach = 2 * edge.a / line.length;
    const Vec3<R> start = t.corners[k] + t.normal * inward;
    const Vec3<R> to_line = start - line.u * dot(start, line.u);
    edge.singular = singular_points(edge.a, frame.distance, R(-dot(frame.base, line.u)), length(to_line),
                                    static_cast<double>(edge.v0));
    frame.edges.push_back(std::move(edge));
  }
  return frame;
}

}  // namespace cageproof::quadrature_ref
