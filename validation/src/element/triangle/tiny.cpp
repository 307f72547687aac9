// SPDX-License-Identifier: MIT
// Triangles in small integers, whose points are next to nothing away, or which are next to nothing, or huge,
// themselves.
#include "regimes.h"

#include "../tiny.h"

namespace cageproof::validation::triangles {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

const ElementType& type() { return type_of(ElementKind::Triangle); }

// Any, in a plane of the axes or in space, starting at any corner.
void place_any(Sample& sample, RandomStream& random) {
  const int turn = random.below(3), flat = random.below(dim);
  sample.corners = integral(random, turn, flat);
  permute_corners(sample, random);
}

// In a plane of the axes through the origin. Returns the third axis.
int place_flat(Sample& sample, RandomStream& random) {
  const int turn = random.below(2), flat = random.below(dim);
  sample.corners = integral(random, turn, flat);
  permute_corners(sample, random);
  return flat;
}

void off(Feature feature, RandomStream& random, Sample& sample) {
  place_any(sample, random);
  const Vec foot = exact_foot(sample.corners, feature, random);
  place_exactly(sample, type(), foot, random, [&] { return tiny_step(random, dim); });
}

// In the plane, outside an edge or a corner.
void beside(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Feature feature = random.below(3) == 0 ? Feature::Vertex : Feature::Edge;
  const Vec foot = exact_foot(sample.corners, feature, random);
  place_exactly(sample, type(), foot, random, [&] { return tiny_step(random, dim, flat); });
}

// Off the centre of a face across all axes, which is the origin.
void off_tilted(RandomStream& random, Sample& sample) {
  auto& t = sample.corners;
  t.assign(3, Vec::Zero());
  Vec normal = Vec::Zero();
  do {
    for (int k = 0; k < 2; ++k) t[k] = random_integers(random, 1, dim);
    t[2] = -(t[0] + t[1]);
    normal = (t[1] - t[0]).cross(t[2] - t[0]);
  } while ((normal.array() != 0).count() < 2);
  place_exactly(sample, type(), Vec::Zero(), random, [&] { return tiny_step(random, dim); });
}

void in_extreme_unit(RandomStream& random, Sample& sample) {
  place_any(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_exactly(sample, type(), foot, random, [&] { return plain_step(random, dim); });
  change_to_extreme_unit(sample, random);
}

// Every other one straight above a face in a plane of the axes, from ten sizes on: there derivatives along the normal
// cancel.
void very_far(RandomStream& random, Sample& sample) {
  if (sample.index / 10 % 2 == 1) {
    place_any(sample, random);
    return place_very_far(sample, random, dim);
  }
  const int flat = place_flat(sample, random);
  sample.point = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  sample.point[flat] = random_sign(random) * std::pow(10.0, random.uniform(1, 20));
}

void with_tilt(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_beside_tilt(sample, type(), foot, flat, random);
}

}  // namespace

// By turns. The first, which the integral and enclosures are asked for in the suite `quick`, is among those
// that cost them least.
void tiny(double, RandomStream& random, Sample& sample) {
  switch (sample.index % 10) {
    case 0: return in_extreme_unit(random, sample);
    case 1: return off(Feature::Line, random, sample);
    case 2: return beside(random, sample);
    case 3: return with_tilt(random, sample);
    case 4: return very_far(random, sample);
    case 5: return off(Feature::Plane, random, sample);
    case 6: return off_tilted(random, sample);
    case 7: return off(Feature::Vertex, random, sample);
    case 8: return off(Feature::Edge, random, sample);
    default: return off(Feature::Face, random, sample);
  }
}

}  // namespace cageproof::validation::triangles
