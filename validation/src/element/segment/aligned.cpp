// SPDX-License-Identifier: MIT
// Segments in small integers, and points at exact places of them.
#include "regimes.h"

#include "../draws.h"

namespace cageproof::validation::segments {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 2;

}  // namespace

std::vector<Vec> integral(RandomStream& random, std::uint64_t turn, int flat) {
  std::vector<Vec> s(2);
  do {
    for (Vec& v : s) v = random_integers(random, 2, dim, turn % 3 != 2 ? flat : -1);
  } while (s[0] == s[1]);
  return s;
}

Vec exact_foot(const std::vector<Vec>& s, Feature feature, RandomStream& random) {
  int i = 0;  // hat function in 16ths
  if (feature == Feature::Face) i = 1 + random.below(15);
  if (feature == Feature::Line) i = random.below(2) == 0 ? 17 + random.below(16) : -1 - random.below(16);
  return ((16 - i) * s[0] + i * s[1]) / 16;
}

// Off a point within it, an end, or its line beyond; every fourth over its middle.
void aligned(double distance, RandomStream& random, Sample& sample) {
  const int flat = random.below(dim);
  sample.corners = integral(random, sample.index, flat);
  const auto& s = sample.corners;
  const bool over_middle = sample.index % 4 == 3;
  constexpr std::array features{Feature::Face, Feature::Vertex, Feature::Line};
  const Feature feature = features[random.below(3)];
  const Vec foot = over_middle ? Vec((s[0] + s[1]) / 2) : exact_foot(s, feature, random);
  const Vec edge = s[1] - s[0], across{edge[1], -edge[0], 0};
  place_exactly(sample, type_of(ElementKind::Segment), foot, random, [&] {
    return Vec(distance * (over_middle ? Vec(random_sign(random) * across) : random_step(random, dim)));
  });
}

}  // namespace cageproof::validation::segments
