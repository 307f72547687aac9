// SPDX-License-Identifier: MIT
// Where exponents, not digits, are the difficulty: distances from where the near-regimes end to the smallest denormal,
// units at the ends of doubles' range.
#pragma once

#include "draws.h"

#include <limits>

namespace cageproof::validation {

/// 10^x, x uniform in (-323.5, -17); one in eight is the smallest denormal.
inline double tiny_distance(RandomStream& random) {
  const bool smallest = random.below(8) == 0;
  const double exponent = random.uniform(-323.5, -17);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  return smallest ? least : std::max(least, std::pow(10.0, exponent));
}

/// A step along an axis or along several: of one tiny length, or in each coordinate of its own. \param flat an axis
/// that it stays at right angles to, or -1
inline Vec3<double> tiny_step(RandomStream& random, int dim, int flat = -1) {
  Vec3<double> step;
  do {
    step = random_step(random, dim);
    if (flat >= 0) step[flat] = 0;
  } while (step == Vec3<double>::Zero());
  const bool alike = random.below(2) == 0;
  const double length = tiny_distance(random);
  for (int c = 0; c < dim; ++c) step[c] *= alike ? length : tiny_distance(random);
  return step;
}

/// A step along an axis or along several, of 1 to 2^-11.
inline Vec3<double> plain_step(RandomStream& random, int dim) {
  const double length = std::ldexp(1.0, -random.below(12));
  return length * random_step(random, dim);
}

/// The whole in a unit of 2^-1046 to 2^-330 (1e-315 to 1e-100), or of 2^330 to 2^990 (1e99 to 1e298): exactly, where
/// coordinates are small multiples of 2^-28.
inline void change_to_extreme_unit(Sample& sample, RandomStream& random) {
  const bool large = random.below(2) == 1;
  const int exponent = large ? 330 + random.below(661) : -330 - random.below(717);
  for (Vec3<double>& v : sample.corners)
    for (double& x : v) x = std::ldexp(x, exponent);
  for (double& x : sample.point) x = std::ldexp(x, exponent);
}

/// The point 1e9 to 1e110 away, along axes or in any direction.
inline void place_very_far(Sample& sample, RandomStream& random, int dim) {
  const double distance = std::pow(10.0, random.uniform(9, 110));
  const bool aligned = random.below(2) == 0;
  const Vec3<double> towards = aligned ? random_step(random, dim) : random_direction(random, dim);
  sample.point = distance * towards;
}

/// Places a flat element in a plane (in the plane: on a line) of the axes through the origin, one corner off it by a
/// tiny distance. The point lies at `foot` in that plane, or a plain or tiny step from it, off the element.
inline void place_beside_tilt(Sample& sample, const ElementType& type, const Vec3<double>& foot, int flat,
                              RandomStream& random) {
  const bool move = random.below(2) == 0;
  if (move)
    for (Vec3<double>& v : sample.corners) v -= foot;
  const std::vector<Vec3<double>> untilted = sample.corners;
  do {
    sample.corners = untilted;
    const int corner = random.below(type.corners);
    const double sign = random_sign(random);
    sample.corners[corner][flat] = sign * tiny_distance(random);
    sample.point = move ? Vec3<double>(Vec3<double>::Zero()) : foot;
    const int step = random.below(3);
    if (step == 1) sample.point += plain_step(random, type.dimension);
    if (step == 2) sample.point += tiny_step(random, type.dimension);
  } while (type.contact(sample.corners, sample.point).contact != Contact::Off);
}

}  // namespace cageproof::validation
