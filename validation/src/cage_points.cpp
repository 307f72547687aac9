// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_points.h"

#include "cageproof/core/random_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

double distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / ab.dot(ab), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

double distance_to_triangle(const Vec& p, const std::array<Vec, 3>& t) {
  const Vec n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool within = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec &a = t[i], &b = t[(i + 1) % 3];
    within = within && (b - a).cross(p - a).dot(n) >= 0;
    nearest = std::min(nearest, distance_to_segment(p, a, b));
  }
  return within ? std::abs((p - t[0]).dot(n)) / n.norm() : nearest;
}

// -1 no crossing, 1 crossing, 0 too close to an edge of the triangle to say (Moeller-Trumbore's determinants).
int crossing(const Vec& origin, const Vec& direction, const std::array<Vec, 3>& t) {
  const Vec e1 = t[1] - t[0], e2 = t[2] - t[0], s = origin - t[0];
  const Vec h = direction.cross(e2), q = s.cross(e1);
  const double a = e1.dot(h);
  const double u = s.dot(h) / a, v = direction.dot(q) / a, along = e2.dot(q) / a;
  constexpr double margin = 1e-9;
  if (!std::isfinite(u) || !std::isfinite(v)) return -1;
  if (u < -margin || v < -margin || u + v > 1 + margin || along <= 0) return -1;
  return u > margin && v > margin && u + v < 1 - margin ? 1 : 0;
}

}  // namespace

std::string_view name_of(Place place) {
  switch (place) {
    case Place::Inside: return "inside";
    case Place::Outside: return "outside";
    case Place::OnFace: return "on-face";
    case Place::OnEdge: return "on-edge";
    case Place::OnVertex: return "on-vertex";
    case Place::TooClose: break;
  }
  return "too-close";
}

CageLocator::CageLocator(const Cage& cage, Triangulation rule) : size_(cage.size()) {
  for (const auto& t : cage.triangulate(rule).triangles)
    triangles_.push_back({cage.vertices()[t[0]], cage.vertices()[t[1]], cage.vertices()[t[2]]});
}

double CageLocator::distance(const Vec& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& t : triangles_) nearest = std::min(nearest, distance_to_triangle(point, t));
  return nearest;
}

bool CageLocator::inside(const Vec& point) const {
  // A ray that grazes an edge says nothing; another is tried.
  for (std::uint64_t attempt = 0;; ++attempt) {
    RandomStream random(0, "rays", attempt);
    Vec direction;
    do direction = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    while (direction.norm() < 0.1);
    int crossings = 0;
    bool clear = true;
    for (const auto& t : triangles_) {
      const int hit = crossing(point, direction, t);
      clear = clear && hit != 0;
      crossings += hit == 1;
    }
    if (clear) return crossings % 2 == 1;
  }
}

Place CageLocator::place(const Vec& point) const {
  if (distance(point) < promised_distance * size_) return Place::TooClose;
  return inside(point) ? Place::Inside : Place::Outside;
}

std::vector<CagePoint> points_off(const Cage& cage, const CageLocator& locator, Triangulation rule, std::uint64_t seed,
                                  int count) {
  const auto triangles = cage.triangulate(rule).triangles;
  Vec low = cage.vertices().front(), high = low;
  for (const Vec& v : cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Vec margin = (high - low) / 4;
  std::vector<CagePoint> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, fmt::format("cage/{}", cage.name()), i);
    Vec p;
    if (i % 2 == 0) {
      for (int c = 0; c < 3; ++c) p[c] = random.uniform(low[c] - margin[c], high[c] + margin[c]);
    } else {
      const auto& t = triangles[random.below(static_cast<int>(triangles.size()))];
      const Vec &a = cage.vertices()[t[0]], &b = cage.vertices()[t[1]], &c = cage.vertices()[t[2]];
      double s = random.uniform(), r = random.uniform();
      if (s + r > 1) {
        s = 1 - s;
        r = 1 - r;
      }
      // A hundredth above the decade: rounding must not put the nearest points below the promised distance.
      const double height = 1.01 * cage.size() * std::pow(10.0, -1 - (i / 2) % 6) * (random.uniform() < 0.5 ? -1.0 : 1.0);
      p = a + s * (b - a) + r * (c - a) + height * (b - a).cross(c - a).normalized();
    }
    points.push_back({p, locator.place(p), static_cast<std::uint64_t>(i)});
  }
  return points;
}

std::vector<CagePoint> points_on(const Cage& cage, Triangulation rule) {
  std::vector<CagePoint> points;
  for (const Vec& v : cage.vertices()) points.push_back({v, Place::OnVertex, points.size()});
  std::set<std::pair<int, int>> edges;
  for (const auto& t : cage.triangulate(rule).triangles) {
    const Vec &a = cage.vertices()[t[0]], &b = cage.vertices()[t[1]], &c = cage.vertices()[t[2]];
    points.push_back({(2 * a + b + c) / 4, Place::OnFace, points.size()});
    for (int i = 0; i < 3; ++i) {
      const int from = t[i], to = t[(i + 1) % 3];
      if (edges.insert(std::minmax(from, to)).second)
        points.push_back({(cage.vertices()[from] + cage.vertices()[to]) / 2, Place::OnEdge, points.size()});
    }
  }
  return points;
}

}  // namespace cageproof::validation
