// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

NearestPlace placed(std::span<const Vec3<double>> corners, const std::array<double, 4>& basis) {
  NearestPlace found{basis};
  for (std::size_t k = 0; k < corners.size(); ++k) found.place += basis[k] * corners[k];
  return found;
}

// The share of the way from a to b.
double share_of_segment(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& point) {
  const Vec3<double> along = b - a;
  return std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

NearestPlace nearest_on_border(std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  NearestPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const double share = share_of_segment(corners[k], corners[next], point);
    std::array<double, 4> basis{};
    basis[k] = 1 - share;
    basis[next] = share;
    const NearestPlace found = placed(corners, basis);
    const double distance = (found.place - point).norm();
    if (!(distance < least)) continue;
    least = distance;
    best = found;
  }
  return best;
}

NearestPlace nearest_on_triangle(std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  const Vec3<double> u = corners[1] - corners[0], v = corners[2] - corners[0], normal = u.cross(v),
                     to = point - corners[0];
  const double area = normal.squaredNorm(), second = to.cross(v).dot(normal) / area,
               third = u.cross(to).dot(normal) / area, first = 1 - second - third;
  if (first >= 0 && second >= 0 && third >= 0) return placed(corners, {first, second, third, 0});
  return nearest_on_border(corners, point);
}

std::array<double, 4> bilinear(double u, double v) { return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}; }

// Starts at the nearest of a few places, and takes Gauss-Newton steps as long as they come nearer.
NearestPlace nearest_on_quad(std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  constexpr int starts = 4, most_steps = 30;
  NearestPlace best = nearest_on_border(corners, point);
  double least = (best.place - point).norm(), best_u = 0, best_v = 0, nearest_start = least;
  bool is_inside = false;
  const auto distance_of = [&](double u, double v) { return (placed(corners, bilinear(u, v)).place - point).norm(); };
  for (int i = 0; i < starts; ++i)
    for (int j = 0; j < starts; ++j) {
      const double u = (i + 0.5) / starts, v = (j + 0.5) / starts, distance = distance_of(u, v);
      if (is_inside && distance >= nearest_start) continue;
      is_inside = true;
      nearest_start = distance;
      best_u = u;
      best_v = v;
    }
  for (int step = 0; step < most_steps; ++step) {
    const Vec3<double> by_u = (1 - best_v) * (corners[1] - corners[0]) + best_v * (corners[2] - corners[3]),
                       by_v = (1 - best_u) * (corners[3] - corners[0]) + best_u * (corners[2] - corners[1]),
                       off = point - placed(corners, bilinear(best_u, best_v)).place;
    const double uu = by_u.squaredNorm(), uv = by_u.dot(by_v), vv = by_v.squaredNorm(), det = uu * vv - uv * uv;
    if (!(det > 0)) break;
    const double u = std::clamp(best_u + (vv * off.dot(by_u) - uv * off.dot(by_v)) / det, 0.0, 1.0),
                 v = std::clamp(best_v + (uu * off.dot(by_v) - uv * off.dot(by_u)) / det, 0.0, 1.0),
                 distance = distance_of(u, v);
    if (!(distance < nearest_start)) break;
    nearest_start = distance;
    best_u = u;
    best_v = v;
  }
  return nearest_start < least ? placed(corners, bilinear(best_u, best_v)) : best;
}

std::array<double, 4> nearest_basis(std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  if (corners.size() == 2) {
    const double share = share_of_segment(corners[0], corners[1], point);
    return {1 - share, share, 0, 0};
  }
  return corners.size() == 3 ? nearest_on_triangle(corners, point).basis : nearest_on_quad(corners, point).basis;
}

}  // namespace

NearestPlace nearest_place(std::span<const Vec3<double>> given, const Vec3<double>& given_point) {
  // Products of lengths stay within range in units of the largest.
  double extent = 0;
  for (const Vec3<double>& corner : given) extent = std::max(extent, (corner - given_point).cwiseAbs().maxCoeff());
  const int exponent = extent > 0 && std::isfinite(extent) ? std::ilogb(extent) : 0;
  std::array<Vec3<double>, 4> scaled;
  for (std::size_t k = 0; k < given.size(); ++k)
    for (int i = 0; i < 3; ++i) scaled[k][i] = std::ldexp(given[k][i] - given_point[i], -exponent);
  return placed(given, nearest_basis(std::span(scaled).first(given.size()), Vec3<double>::Zero()));
}

}  // namespace cageproof
