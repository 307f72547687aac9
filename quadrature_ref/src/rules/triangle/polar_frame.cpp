// SPDX-License-Identifier: MIT
#include "polar_frame.h"

#include "../exact_element.h"

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

using R = Mp200;

bool projects_inside(const std::array<EdgeLine, 3>& lines) {
  return std::ranges::all_of(lines, [](const EdgeLine& line) { return line.inside >= 0; });
}

// The triangle's point c that is nearest to eta: eta's projection, or a point within an edge, or a corner.
struct Nearest {
  int edge = -1, corner = -1;
  Vec3<R> x;  ///< c - eta

  bool on_edge(int k) const { return k == edge || k == corner || (corner >= 0 && k == (corner + 2) % 3); }
};

Nearest nearest_point(const LinedTriangle& t) {
  const auto& lines = t.lines;
  Nearest best;
  if (projects_inside(lines)) {
    best.x = t.normal * t.height;
    // Exactly above the border c is on it.
    for (int k = 0; k < 3; ++k)
      if (lines[k].inside == 0) best.edge = k;
    for (int k = 0; k < 3; ++k)
      if (lines[k].inside == 0 && lines[(k + 2) % 3].inside == 0) best.corner = k;
    return best;
  }
  R best_square = -1;
  for (int k = 0; k < 3; ++k) {
    Nearest candidate;
    if (lines[k].start >= 0) candidate.corner = k;
    else if (lines[k].end <= 0) candidate.corner = (k + 1) % 3;
    else candidate.edge = k;
    candidate.x = candidate.corner >= 0 ? t.corners[candidate.corner]
                                        : Vec3<R>(lines[k].nu * lines[k].inside + t.normal * t.height);
    const R square = dot(candidate.x, candidate.x);
    if (best_square < 0 || square < best_square) {
      best_square = square;
      best = candidate;
    }
  }
  return best;
}

// An edge's line from c: its distance, where along u the edge starts and ends, and where eta is.
struct EdgeFromNearest {
  R away, start, end, along;
};

// Computes small numbers directly, never as differences of large ones.
EdgeFromNearest seen_from(const Nearest& c, const LinedTriangle& t, int k) {
  const EdgeLine& line = t.lines[k];
  const int before = (k + 2) % 3, after = (k + 1) % 3;  // the edges that end and start where this one starts and ends
  const R along = -dot(c.x, line.u);
  if (c.corner >= 0)
    return {t.twice_area / line.length, dot(line.u, t.edges[before]), -dot(line.u, t.edges[after]), along};
  if (c.edge < 0) return {line.inside, line.start, line.end, R(0)};
  const EdgeLine& on = t.lines[c.edge];
  const R cosine = dot(line.u, on.u), sine = t.twice_area / (line.length * on.length);
  if (c.edge == before) {
    const R start = cosine * on.end;
    return {sine * on.end, start, start + line.length, along};
  }
  const R end = cosine * on.start;
  return {-sine * on.start, end - line.length, end, along};
}

// The integrand is singular in v where the ray's foot (cosh v = 0) or r at the edge vanishes, and where w at the edge,
// asinh of a cosh v / distance, has its branch points.
Singularities singular_points(const R& a, const R& distance, const R& along, const R& line_distance, double v0) {
  using Place = std::complex<double>;
  constexpr double kHalfPi = std::numbers::pi / 2;
  const double branch = asinh_of_exp(log_magnitude(R(distance / a)));
  Singularities points{Place(-v0, kHalfPi), Place(branch - v0, kHalfPi), Place(-branch - v0, kHalfPi)};
  const R modulus = sqrt(along * along + line_distance * line_distance);
  if (modulus == 0) return points;
  // sinh takes each value twice in the strip 0 < Im v < pi.
  const double log_modulus = log_magnitude(R(modulus / a));
  const Place direction(static_cast<double>(along / modulus), static_cast<double>(line_distance / modulus));
  const Place v = log_modulus > 30 ? std::log(direction) + Place(log_modulus + std::numbers::ln2, 0)
                                   : std::asinh(std::exp(log_modulus) * direction);
  points.push_back(v - v0);
  points.push_back(Place(-v.real() - v0, std::numbers::pi - v.imag()));
  return points;
}

}  // namespace

std::optional<LinedTriangle> lined_triangle(std::span<const Vec3<R>> corners, const Vec3<R>& point) {
  LinedTriangle t;
  if (!t.set(corners, point)) return std::nullopt;
  const auto exact = exact_triangle(corners, point, t.exponent);
  if (!exact) return std::nullopt;
  t.twice_area = length(exact->normal);
  if (!(t.twice_area > 0)) return std::nullopt;
  t.normal = exact->normal / t.twice_area;
  t.height = exact->volume / t.twice_area;
  t.corners = exact->corners;
  t.edges = exact->edges;
  for (int k = 0; k < 3; ++k) {
    EdgeLine& line = t.lines[k];
    line.length = length(t.edges[k]);
    line.u = t.edges[k] / line.length;
    line.nu = exact->outward[k] / (line.length * t.twice_area);
    line.inside = exact->inside[k] / (line.length * t.twice_area);
    line.start = exact->start[k] / line.length;
    line.end = exact->end[k] / line.length;
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
  frame.interior = nearest.edge < 0 && nearest.corner < 0;
  frame.exponent = t.exponent;
  frame.along = lines[0].u;
  frame.across = lines[0].nu;
  for (int k = 0; k < 3; ++k) {
    const EdgeLine& line = lines[k];
    const int opposite = (k + 2) % 3;  // its hat function vanishes on edge k
    const R steepness = line.length / t.twice_area;
    frame.slope_along[opposite] = -dot(line.nu, frame.along) * steepness;
    frame.slope_across[opposite] = -dot(line.nu, frame.across) * steepness;
    frame.hat[opposite] = 0;
    if (nearest.on_edge(k)) continue;
    const EdgeFromNearest seen = seen_from(nearest, t, k);
    frame.hat[opposite] = seen.away * steepness;
    if (!(seen.away > 0)) continue;
    PolarEdge<R> edge;
    edge.nu = line.nu;
    edge.u = line.u;
    edge.a = seen.away;
    edge.v0 = inverse_sinh(R(seen.start / edge.a));
    edge.v_length = inverse_sinh(R(seen.end / edge.a)) - edge.v0;
    edge.start = k;
    edge.relative_height = 2 * edge.a / line.length;
    const R line_distance = sqrt(line.inside * line.inside + frame.height * frame.height);
    edge.singular = singular_points(edge.a, frame.distance, seen.along, line_distance, static_cast<double>(edge.v0));
    frame.edges.push_back(std::move(edge));
  }
  return frame;
}

}  // namespace cageproof::quadrature_ref
