// SPDX-License-Identifier: MIT
#include "pairs.h"

#include "cageproof/core/numbers/random_stream.h"

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

// Its longest side is one, its length or twice its area at least a fifth.
std::vector<Vec> element_of_size_one(RandomStream& random, const ElementType& type) {
  std::vector<Vec> corners(static_cast<std::size_t>(type.corners));
  do {
    for (Vec& v : corners) v = random_in_ball(random, type.dimension);
    const double longest = longest_side(corners);
    for (Vec& v : corners) v /= longest;
  } while (type.extent(corners).norm() < 0.2);
  return corners;
}

}  // namespace

std::vector<Pair> generic_pairs(ElementKind element) {
  const ElementType& type = type_of(element);
  std::vector<Pair> pairs(kPairCount);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    RandomStream random(kSeed, type.name, i);
    auto& [corners, point] = pairs[i];
    corners = element_of_size_one(random, type);
    Vec centroid = Vec::Zero();
    for (const Vec& v : corners) centroid += v / static_cast<double>(corners.size());
    // Drawn one after the other: the order in which operands are evaluated is open.
    const double distance = random.uniform(0.5, 1.5);
    const Vec direction = random_in_ball(random, type.dimension).normalized();
    point = centroid + distance * direction;
  }
  return pairs;
}

}  // namespace cageproof::benchmarks
