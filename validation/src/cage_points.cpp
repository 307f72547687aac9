// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_points.h"

#include "cageproof/core/random_stream.h"
#include "bilinear_patch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

// -1 where the ray comes too close to an edge of the triangle to say (Moeller-Trumbore's determinants).
int crossings_of_triangle(const Vec& origin, const Vec& direction, const Triangle<double>& t) {
  const Vec e1 = t[1] - t[0], e2 = t[2] - t[0], s = origin - t[0];
  const Vec h = direction.cross(e2), q = s.cross(e1);
  const double a = e1.dot(h);
  const double u = s.dot(h) / a, v = direction.dot(q) / a, along = e2.dot(q) / a;
  constexpr double margin = 1e-9;
  if (!std::isfinite(u) || !std::isfinite(v)) return 0;
  if (u < -margin || v < -margin || u + v > 1 + margin || along <= 0) return 0;
  return u > margin && v > margin && u + v < 1 - margin ? 1 : -1;
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

CageLocator::CageLocator(const Cage& cage, Triangulation rule, bool keep_quads) : size_(cage.size()) {
  const auto& vertices = cage.vertices();
  const auto add = [&](int face, int a, int b, int c) { patches_.push_back({{vertices[a], vertices[b], vertices[c], vertices[c]}, 3, face}); };
  const auto split = cage.triangulate(rule);
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    const auto& [a, b, c] = split.triangles[t];
    const int face = split.face_of[t];
    if (!keep_quads || cage.faces()[face].size() == 3) add(face, a, b, c);
    else if (patches_.empty() || patches_.back().face != face) patches_.push_back({cage.quad(face), 4, face});
  }
}

double CageLocator::distance(const Vec& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Patch& patch : patches_) {
    const auto& c = patch.corners;
    const double d = patch.size == 3 ? distance_to_triangle(point, {c[0], c[1], c[2]}) : distance_to_quad(point, c, nearest);
    nearest = std::min(nearest, d);
  }
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
    for (const Patch& patch : patches_) {
      const auto& c = patch.corners;
      const int hits = patch.size == 3 ? crossings_of_triangle(point, direction, {c[0], c[1], c[2]})
                                       : crossings_of_quad(point, direction, c);
      clear = clear && hits >= 0;
      crossings += hits;
    }
    if (clear) return crossings % 2 == 1;
  }
}

SurfacePoint CageLocator::surface_point(int patch, double s, double r) const {
  const auto& c = patches_[patch].corners;
  if (patches_[patch].size == 3) {
    if (s + r > 1) {
      s = 1 - s;
      r = 1 - r;
    }
    return {c[0] + s * (c[1] - c[0]) + r * (c[2] - c[0]), (c[1] - c[0]).cross(c[2] - c[0]).normalized()};
  }
  const Vec along_s = (1 - r) * (c[1] - c[0]) + r * (c[2] - c[3]), along_r = (1 - s) * (c[3] - c[0]) + s * (c[2] - c[1]);
  return {(1 - s) * (1 - r) * c[0] + s * (1 - r) * c[1] + s * r * c[2] + (1 - s) * r * c[3], along_s.cross(along_r).normalized()};
}

Place CageLocator::place(const Vec& point) const {
  if (distance(point) < promised_distance * size_) return Place::TooClose;
  return inside(point) ? Place::Inside : Place::Outside;
}

std::vector<CagePoint> points_off(const Cage& cage, const CageLocator& locator, std::uint64_t seed, int count) {
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
      const int patch = random.below(locator.patches());
      const double s = random.uniform(), r = random.uniform();
      const SurfacePoint on = locator.surface_point(patch, s, r);
      // A hundredth above the decade: rounding must not put the nearest points below the promised distance.
      const double height = 1.01 * cage.size() * std::pow(10.0, -1 - (i / 2) % 6) * (random.uniform() < 0.5 ? -1.0 : 1.0);
      p = on.point + height * on.normal;
    }
    points.push_back({p, locator.place(p), static_cast<std::uint64_t>(i)});
  }
  return points;
}

std::vector<CagePoint> points_on(const CageCoordinates& coordinates, const Cage& cage) {
  std::vector<CagePoint> points;
  const auto add = [&](const Vec& p, Place place) { points.push_back({p, place, points.size()}); };
  for (const Vec& v : cage.vertices()) add(v, Place::OnVertex);
  std::set<std::pair<int, int>> edges;
  for (int e = 0; e < static_cast<int>(coordinates.elements().size()); ++e) {
    const Face& element = coordinates.elements()[e];
    const auto c = coordinates.corners(e);
    if (element.size() == 3) {
      add((2 * c[0] + c[1] + c[2]) / 4, Place::OnFace);
    } else {
      add((c[0] + c[1] + c[2] + c[3]) / 4, Place::OnFace);                // u = v = 1/2
      add((9 * c[0] + 3 * c[1] + c[2] + 3 * c[3]) / 16, Place::OnFace);  // u = v = 1/4
    }
    for (int i = 0; i < element.size(); ++i) {
      const int from = element.vertices[i], to = element.vertices[(i + 1) % element.size()];
      if (edges.insert(std::minmax(from, to)).second) add((cage.vertices()[from] + cage.vertices()[to]) / 2, Place::OnEdge);
    }
  }
  return points;
}

}  // namespace cageproof::validation
