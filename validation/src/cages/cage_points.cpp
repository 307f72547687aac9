// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_points.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/random_stream.h"
#include "element/element_sampling.h"
#include "run/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

// A weighted sum of corners over 16, and whether no rounding was in it: each product and sum leaves no remainder.
class SixteenthsSum {
 public:
  void add(double weight, const Vec& corner) {
    for (int c = 0; c < 3; ++c) {
      const double term = weight * corner[c], sum = sum_[c] + term, back = sum - sum_[c];
      exact_ = exact_ && std::fma(weight, corner[c], -term) == 0 && sum_[c] - (sum - back) == 0 && term - back == 0;
      sum_[c] = sum;
    }
  }
  CagePoint point(Place place, std::size_t index) const {
    const Vec mean = sum_ / 16;
    return {mean, place, index, exact_ && 16 * mean == sum_};
  }

 private:
  Vec sum_ = Vec::Zero();
  bool exact_ = true;
};

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

CageLocator::CageLocator(const Cage& cage, Triangulation rule, bool keep_quads)
    : CageLocator(CageElements(cage, keep_quads, rule), cage.size()) {}

CageLocator::CageLocator(const CageElements& elements, double size) : windings_(elements), size_(size) {
  for (std::size_t e = 0; e < elements.count(); ++e) patches_.push_back({elements.type(e).kind, elements.corners(e)});
}

double CageLocator::distance(const Vec& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Patch& patch : patches_)
    nearest = std::min(nearest, sampling_of(patch.kind).locator.distance(patch.corners, point, nearest));
  return nearest;
}

double CageLocator::distance_but_to(std::span<const Touching> named, const Vec& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int p = 0; p < patches(); ++p)
    if (std::ranges::find(named, p, &Touching::element) == named.end())
      nearest = std::min(nearest, sampling_of(patches_[p].kind).locator.distance(patches_[p].corners, point, nearest));
  return nearest;
}

SurfacePoint CageLocator::surface_point(int patch, double s, double r) const {
  return sampling_of(patches_[patch].kind).locator.surface_point(patches_[patch].corners, s, r);
}

Place CageLocator::place(const Vec& point) const {
  if (distance(point) < promised_distance * size_) return Place::TooClose;
  return inside(point) ? Place::Inside : Place::Outside;
}

std::vector<CagePoint> points_off(const Cage& cage, const CageLocator& locator, std::uint64_t seed, int count) {
  const auto [low, high] = box_of(cage.vertices());
  const Vec margin = (high - low) / 4;
  const std::string stream = fmt::format("cage/{}", drawn_by(cage));
  std::vector<CagePoint> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(seed, stream, i);
    Vec p = Vec::Zero();
    if (i % 2 == 0) {
      for (int c = 0; c < cage.dimension(); ++c) p[c] = random.uniform(low[c] - margin[c], high[c] + margin[c]);
    } else {
      const int patch = random.below(locator.patches());
      const double s = random.uniform(), r = random.uniform();
      const SurfacePoint on = locator.surface_point(patch, s, r);
      // A hundredth above the decade: rounding must not put the nearest points below the promised distance.
      const double height =
          1.01 * cage.size() * std::pow(10.0, -1 - (i / 2) % 6) * (random.uniform() < 0.5 ? -1.0 : 1.0);
      p = on.point + height * on.normal;
    }
    points.push_back({p, locator.place(p), static_cast<std::uint64_t>(i)});
  }
  return points;
}

std::vector<CagePoint> points_on(const CageCoordinates& coordinates, const Cage& cage) {
  std::vector<CagePoint> points;
  for (const Vec& v : cage.vertices()) points.push_back({v, Place::OnVertex, points.size(), true});
  std::set<std::pair<int, int>> edges;
  const CageElements& elements = coordinates.elements();
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    const auto vertices = elements.vertices_of(e);
    for (const auto& sixteenths : elements.type(e).interior_points) {
      SixteenthsSum sum;
      for (std::size_t k = 0; k < corners.size(); ++k) sum.add(sixteenths[k], corners[k]);
      points.push_back(sum.point(Place::OnFace, points.size()));
    }
    for (int i = 0; i < sampling_of(elements.type(e).kind).border_edges; ++i) {
      const int from = vertices[i], to = vertices[(i + 1) % vertices.size()];
      if (!edges.insert(std::minmax(from, to)).second) continue;
      SixteenthsSum sum;
      for (const int v : {from, to}) sum.add(8, cage.vertices()[v]);
      points.push_back(sum.point(Place::OnEdge, points.size()));
    }
  }
  return points;
}

}  // namespace cageproof::validation
