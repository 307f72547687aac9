// SPDX-License-Identifier: MIT
#include "pairs.h"

#include "cageproof/core/random_stream.h"

#include <algorithm>

namespace cageproof::benchmarks {
namespace {

using Vec = Vec3<double>;

constexpr std::uint64_t kSeed = 1;

Vec random_in_ball(RandomStream& random, int dim) {
  for (;;) {
    Vec v = Vec::Zero();
    for (int c = 0; c < dim; ++c) v[c] = random.uniform(-1, 1);
    if (v.norm() < 1) return v;
  }
}

double longest_side(const std::vector<Vec>& corners) {
  double longest = 0;
  for (const Vec& a : corners)
    for (const Vec& b : corners) longest = std::max(longest, (a - b).norm());
  return longest;
}

// Length of a segment, area of the fan of triangles about the first corner.
double extent(const std::vector<Vec>& corners) {
  if (corners.size() == 2) return (corners[1] - corners[0]).norm();
  Vec sum = Vec::Zero();
  for (std::size_t k = 2; k < corners.size(); ++k) sum += (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]);
  return sum.norm() / 2;
}

std::vector<Vec> element_of_size_one(RandomStream& random, int corner_count, int dim) {
  std::vector<Vec> corners(static_cast<std::size_t>(corner_count));
  do {
    for (Vec& v : corners) v = random_in_ball(random, dim);
    const double longest = longest_side(corners);
    for (Vec& v : corners) v /= longest;
  } while (extent(corners) < 0.1);
  return corners;
}

}  // namespace

std::vector<Pair> generic_pairs(ElementKind element) {
  const int dim = dimension(element);
  std::vector<Pair> pairs(kPairCount);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    RandomStream random(kSeed, name_of(element), i);
    auto& [corners, point] = pairs[i];
    corners = element_of_size_one(random, corner_count(element), dim);
    Vec centroid = Vec::Zero();
    for (const Vec& v : corners) centroid += v / static_cast<double>(corners.size());
    // Drawn one after the other: the order in which operands are evaluated is open.
    const double distance = random.uniform(0.5, 1.5);
    const Vec direction = random_in_ball(random, dim).normalized();
    point = centroid + distance * direction;
  }
  return pairs;
}

}  // namespace cageproof::benchmarks
