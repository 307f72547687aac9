// SPDX-License-Identifier: MIT
// Positive mean value coordinates: what is hidden counts nothing, and all else as in mean value coordinates.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/point_places.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <map>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;

std::vector<double> coordinates_at(const Cage& cage, const char* kind, const Vec& point) {
  return CageCoordinates(cage, coordinate_kind_named(kind), CoordinateOptions{}).at<double>(point, 0).front().value;
}

std::vector<Vec> points_inside(const Cage& cage, int count) {
  const PointPlaces places(cage, false, Triangulation::Shortest);
  Vec low = cage.vertices()[0], high = low;
  for (const Vec& v : cage.vertices()) low = low.cwiseMin(v), high = high.cwiseMax(v);
  std::vector<Vec> found;
  for (int i = 0; static_cast<int>(found.size()) < count; ++i) {
    RandomStream random(1, "inside", i);
    const Vec at(random.uniform(low[0], high[0]), random.uniform(low[1], high[1]), random.uniform(low[2], high[2]));
    if (places.at(at).place == Place::Inside) found.push_back(at);
  }
  return found;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(positive_mean_value, is_mean_value_where_all_is_seen) {
  for (const char* name : {"cube", "icosphere"}) {
    const Cage cage = embedded_cage(name);
    for (const Vec& at : points_inside(cage, 8))
      EXPECT_LT(
          largest_difference(coordinates_at(cage, "positive_mean_value", at), coordinates_at(cage, "mean_value", at)),
          1e-13)
          << name;
  }
}

TEST(positive_mean_value, is_positive_and_reproduces_linear_functions_where_parts_are_hidden) {
  const Cage cage = embedded_cage("l-block");
  double least = 1, least_of_all_seen = 1, apart = 0;
  for (const Vec& at : points_inside(cage, 24)) {
    const auto found = coordinates_at(cage, "positive_mean_value", at), all = coordinates_at(cage, "mean_value", at);
    Vec sum = Vec::Zero();
    double ones = 0;
    for (std::size_t v = 0; v < found.size(); ++v) {
      sum += found[v] * cage.vertices()[v];
      ones += found[v];
      least = std::min(least, found[v]);
      least_of_all_seen = std::min(least_of_all_seen, all[v]);
    }
    EXPECT_NEAR(ones, 1, 1e-14);
    EXPECT_LT((sum - at).norm(), 1e-14);
    apart = std::max(apart, largest_difference(found, all));
  }
  EXPECT_GE(least, 0);
  EXPECT_LT(least_of_all_seen, -1e-3) << "mean value coordinates are negative there";
  EXPECT_GT(apart, 1e-2);
}

// Each triangle cut in four: the same surface, so that hat functions of the coarse one are sums of those of the fine
// one. Parts that are seen are cut otherwise.
TEST(positive_mean_value, stays_when_faces_are_divided) {
  const Cage cage = embedded_cage("l-block");
  const auto coarse = cage.triangulate(Triangulation::Shortest).triangles;
  std::vector<Vec> vertices = cage.vertices();
  std::vector<Face> whole, parts;
  std::map<std::pair<int, int>, int> middles;
  std::vector<std::array<int, 2>> ends;
  for (const auto& t : coarse) {
    std::array<int, 3> m{};
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
      if (is_new) {
        vertices.push_back((vertices[a] + vertices[b]) / 2);
        ends.push_back({a, b});
      }
      m[k] = at->second;
    }
    whole.push_back({{t[0], t[1], t[2], -1}});
    for (int k = 0; k < 3; ++k) parts.push_back({{t[k], m[k], m[(k + 2) % 3], -1}});
    parts.push_back({{m[0], m[1], m[2], -1}});
  }
  const Cage undivided = Cage::make("whole", cage.vertices(), whole), divided = Cage::make("divided", vertices, parts);
  for (const Vec& at : points_inside(cage, 12)) {
    const auto found = coordinates_at(undivided, "positive_mean_value", at);
    const auto fine = coordinates_at(divided, "positive_mean_value", at);
    std::vector<double> gathered(fine.begin(), fine.begin() + static_cast<std::ptrdiff_t>(found.size()));
    for (std::size_t m = 0; m < ends.size(); ++m)
      for (const int end : ends[m]) gathered[end] += fine[found.size() + m] / 2;
    EXPECT_LT(largest_difference(found, gathered), 1e-14);
  }
}

TEST(positive_mean_value, meets_the_cage_and_ends_there) {
  const Cage cage = embedded_cage("l-block");
  const auto triangles = cage.triangulate(Triangulation::Shortest).triangles;
  const auto corner = [&](int k) { return cage.vertices()[triangles[0][k]]; };
  const auto on = coordinates_at(cage, "positive_mean_value", corner(0) / 2 + corner(1) / 4 + corner(2) / 4);
  EXPECT_EQ(on[triangles[0][0]], 0.5);
  EXPECT_EQ(on[triangles[0][1]], 0.25);
  EXPECT_TRUE(std::isnan(coordinates_at(cage, "positive_mean_value", Vec(1e3, 0, 0))[0]));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
