// SPDX-License-Identifier: MIT
// Quads in small integers with points a tiny distance away, and quads that are tiny or huge themselves.
#include "regimes.h"

#include "../tiny.h"

#include "cageproof/core/geometry/quad_geometry.h"

namespace cageproof::validation::quads {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

const ElementType& type() { return type_of(ElementKind::Quad); }

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

// In the plane, outside a side or a corner.
void beside(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Feature feature = random.below(3) == 0 ? Feature::Vertex : Feature::Edge;
  const Vec foot = exact_foot(sample.corners, feature, random);
  place_exactly(sample, type(), foot, random, [&] { return tiny_step(random, dim, flat); });
}

// Off the centre, which is the origin, of a quad across all axes, flat or twisted.
void off_tilted(RandomStream& random, Sample& sample) {
  auto& q = sample.corners;
  do {
    const Vec a = random_integers(random, 1, dim);
    const Vec b = random_integers(random, 1, dim);
    const bool twisted = random.below(2) == 1;
    const Vec lift = twisted ? random_integers(random, 1, dim) : Vec(Vec::Zero());
    q = {a + lift, b - lift, lift - a, -b - lift};
  } while (invalid_because({q[0], q[1], q[2], q[3]}) || (type().extent(q).array() != 0).count() < 2);
  place_exactly(sample, type(), Vec::Zero(), random, [&] { return tiny_step(random, dim); });
}

void in_extreme_unit(RandomStream& random, Sample& sample) {
  place_any(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_exactly(sample, type(), foot, random, [&] { return plain_step(random, dim); });
  change_to_extreme_unit(sample, random);
}

void very_far(RandomStream& random, Sample& sample) {
  place_any(sample, random);
  place_very_far(sample, random, dim);
}

void with_tilt(RandomStream& random, Sample& sample) {
  const int flat = place_flat(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_beside_tilt(sample, type(), foot, flat, random);
}

}  // namespace

// By turns. The suite `quick` takes five, of which the integral is asked for the first: it costs least there.
void tiny(double, RandomStream& random, Sample& sample) {
  switch (sample.index % 10) {
    case 0: return in_extreme_unit(random, sample);
    case 1: return beside(random, sample);
    case 2: return off(Feature::Face, random, sample);
    case 3: return with_tilt(random, sample);
    case 4: return off(Feature::Vertex, random, sample);
    case 5: return very_far(random, sample);
    case 6: return off_tilted(random, sample);
    case 7: return off(Feature::Edge, random, sample);
    case 8: return off(Feature::Plane, random, sample);
    default: return off(Feature::Line, random, sample);
  }
}

}  // namespace cageproof::validation::quads
