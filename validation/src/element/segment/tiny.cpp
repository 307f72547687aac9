// SPDX-License-Identifier: MIT
// Segments in small integers with points a tiny distance away, and segments that are tiny or huge themselves.
#include "regimes.h"

#include "../tiny.h"

namespace cageproof::validation::segments {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 2;

const ElementType& type() { return type_of(ElementKind::Segment); }

void place_any(Sample& sample, RandomStream& random) {
  const int turn = random.below(3), flat = random.below(dim);
  sample.corners = integral(random, turn, flat);
}

// Along an axis, through the origin or its line. Returns the other axis.
int place_flat(Sample& sample, RandomStream& random) {
  const int flat = random.below(dim);
  sample.corners = integral(random, 0, flat);
  return flat;
}

Feature any_feature(RandomStream& random) {
  static constexpr std::array features{Feature::Face, Feature::Vertex, Feature::Line};
  return features[random.below(3)];
}

void off(Feature feature, RandomStream& random, Sample& sample) {
  place_any(sample, random);
  const Vec foot = exact_foot(sample.corners, feature, random);
  place_exactly(sample, type(), foot, random, [&] { return tiny_step(random, dim); });
}

// On its line, outside an end.
void beside(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Vec foot = exact_foot(sample.corners, Feature::Vertex, random);
  place_exactly(sample, type(), foot, random, [&] { return tiny_step(random, dim, flat); });
}

// Off the middle, which is the origin, of a segment across both axes.
void off_tilted(RandomStream& random, Sample& sample) {
  Vec half;
  do {
    half = random_integers(random, 3, dim);
  } while (half[0] == 0 || half[1] == 0);
  sample.corners = {half, -half};
  place_exactly(sample, type(), Vec::Zero(), random, [&] { return tiny_step(random, dim); });
}

void in_extreme_unit(RandomStream& random, Sample& sample) {
  place_any(sample, random);
  const Vec foot = exact_foot(sample.corners, any_feature(random), random);
  place_exactly(sample, type(), foot, random, [&] { return plain_step(random, dim); });
  change_to_extreme_unit(sample, random);
}

void very_far(RandomStream& random, Sample& sample) {
  place_any(sample, random);
  place_very_far(sample, random, dim);
}

void with_tilt(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Vec foot = exact_foot(sample.corners, any_feature(random), random);
  place_beside_tilt(sample, type(), foot, flat, random);
}

}  // namespace

// By turns. The first, which the integral is asked for in the suite `quick`, is among those that cost it
// least.
void tiny(double, RandomStream& random, Sample& sample) {
  switch (sample.index % 8) {
    case 0: return in_extreme_unit(random, sample);
    case 1: return beside(random, sample);
    case 2: return off(Feature::Face, random, sample);
    case 3: return with_tilt(random, sample);
    case 4: return very_far(random, sample);
    case 5: return off_tilted(random, sample);
    case 6: return off(Feature::Line, random, sample);
    default: return off(Feature::Vertex, random, sample);
  }
}

}  // namespace cageproof::validation::segments
