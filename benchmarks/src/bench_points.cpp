// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/benchmarks/work_precision.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

using Vec = Vec3<double>;
constexpr double interior_distance = 1e-1;
constexpr int attempts = 2000;

// The first of `attempts` candidates that is inside and no nearer to the cage than `least`; nothing if there is none.
template <class Candidate>
void add_point(PointGroup& group, const CageLocator& locator, double least, std::uint64_t index, Candidate candidate) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Vec p = candidate();
    if (locator.distance(p) < least || !locator.inside(p)) continue;
    group.points.push_back({p, Place::Inside, index});
    return;
  }
}

}  // namespace

std::vector<PointGroup> groups_inside(const Cage& cage, const CageLocator& locator, std::uint64_t seed, int count) {
  const auto [low, high] = box_of(cage.vertices());
  std::vector<PointGroup> groups{{"interior", interior_distance, {}}};
  for (int decade = 1; decade <= 4; ++decade)
    groups.push_back({fmt::format("1e-{}", decade), std::pow(10.0, -decade), {}});
  for (PointGroup& group : groups)
    for (int i = 0; i < count; ++i) {
      RandomStream random(seed, fmt::format("bench/{}/{}", cage.name(), group.place), i);
      const double height = group.distance * cage.size();
      if (&group == &groups.front()) {
        add_point(group, locator, height, i, [&] {
          Vec p;
          for (int c = 0; c < 3; ++c) p[c] = random.uniform(low[c], high[c]);
          return p;
        });
        continue;
      }
      // A little less than the height, which rounding may take from it.
      add_point(group, locator, 0.999 * height, i, [&] {
        const int patch = random.below(locator.patches());
        const double along = random.uniform(), across = random.uniform();
        const SurfacePoint on = locator.surface_point(patch, along, across);
        return Vec(on.point - height * on.normal);
      });
    }
  return groups;
}

std::vector<PointGroup> groups_of(const Cage& cage, const CageLocator& locator, const std::vector<Vec>& points) {
  std::map<int, PointGroup, std::greater<>> by_decade;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Place place = locator.place(points[i]);
    if (place == Place::TooClose) continue;
    const int decade = static_cast<int>(std::floor(std::log10(locator.distance(points[i]) / cage.size())));
    PointGroup& group =
        by_decade
            .try_emplace(decade, PointGroup{fmt::format("1e{}..1e{}", decade, decade + 1), std::pow(10.0, decade), {}})
            .first->second;
    group.points.push_back({points[i], place, i});
  }
  std::vector<PointGroup> groups;
  groups.reserve(by_decade.size());
  for (auto& [decade, group] : by_decade) groups.push_back(std::move(group));
  return groups;
}

}  // namespace cageproof::benchmarks
