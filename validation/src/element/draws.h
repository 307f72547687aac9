// SPDX-License-Identifier: MIT
// Draws that the makers of samples share. Each stands in a statement of its own, because within an expression C++
// leaves the order of function arguments and of most operands open.
#pragma once

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/sample.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {

/// Coordinates uniform in [-half, half); those beyond `dim` are zero.
inline Vec3<double> random_in_box(RandomStream& random, double half, int dim) {
  Vec3<double> v = Vec3<double>::Zero();
  for (int c = 0; c < dim; ++c) v[c] = random.uniform(-half, half);
  return v;
}

/// A unit vector.
inline Vec3<double> random_direction(RandomStream& random, int dim) {
  for (;;) {
    const Vec3<double> v = random_in_box(random, 1, dim);
    const double length = v.norm();
    if (length > 0.1 && length < 1) return v / length;
  }
}

inline double random_sign(RandomStream& random) { return random.uniform() < 0.5 ? -1 : 1; }

/// Half of the samples put the nearest point of the element at the origin: the only way to be 1e-16 sizes away exactly.
inline void place_near(Sample& sample, const Vec3<double>& foot, const Vec3<double>& away, RandomStream& random) {
  if (random.uniform() < 0.5) {
    for (Vec3<double>& v : sample.corners) v -= foot;
    sample.point = away;
  } else {
    sample.point = foot + away;
  }
}

/// Moves the point by one ulp in that coordinate.
inline void move_by_one_ulp_along(int axis, Sample& sample, RandomStream& random) {
  double& x = sample.point[axis];
  // One ulp off zero is a denormal (5e-324), far below any element's size: there the ulp is that of a corner's step.
  const double size = std::max(std::abs(x), 1.0 / 64);
  const double ulp = std::nextafter(size, 2.0) - size;
  x += random_sign(random) * ulp;
}

/// Moves the point by one ulp in one coordinate.
inline void move_by_one_ulp(Sample& sample, RandomStream& random, int dim) {
  move_by_one_ulp_along(random.below(dim), sample, random);
}

/// Coordinates that are integers from -most to most; `flat` ones are zero, as are those beyond `dim`.
inline Vec3<double> random_integers(RandomStream& random, int most, int dim, int flat = -1) {
  Vec3<double> v = Vec3<double>::Zero();
  for (int c = 0; c < dim; ++c) {
    const int drawn = random.below(2 * most + 1) - most;
    if (c != flat) v[c] = drawn;
  }
  return v;
}

/// A unit vector along an axis.
inline Vec3<double> unit_along(int axis) { return Vec3<double>::Unit(axis); }

/// Along an axis, or a step of one, none or minus one along each.
inline Vec3<double> random_step(RandomStream& random, int dim) {
  if (random.below(2) == 0) {
    const int axis = random.below(dim);
    return random_sign(random) * unit_along(axis);
  }
  for (;;) {
    Vec3<double> step = random_integers(random, 1, dim);
    if (step != Vec3<double>::Zero()) return step;
  }
}

/// Where on an element, or in its plane or on an edge's line beyond it.
enum class Feature { Face, Edge, Vertex, Plane, Line };

/// The point at a drawn step from `foot`, whose coordinates are exact, and off the element. In
/// two of three samples the whole is moved, exactly, so that `foot` is the origin: then the step is exact as well.
/// \param draw_step draws the step, as often as the point is not off the element
template <class DrawStep>
void place_exactly(Sample& sample, const ElementType& type, const Vec3<double>& foot, RandomStream& random,
                   DrawStep&& draw_step) {
  bool moved = false, lost = false;
  do {
    // Next to coordinates that are not zero a step may be lost in rounding.
    const bool move = random.below(3) > 0;
    if (move && !moved)
      for (Vec3<double>& v : sample.corners) v -= foot;
    moved = moved || move;
    const Vec3<double> away = draw_step();
    sample.point = moved ? away : Vec3<double>(foot + away);
    lost = !moved && sample.point == foot;
  } while (lost || type.contact(sample.corners, sample.point).contact != Contact::Off);
}

/// Starts at another corner.
inline void permute_corners(Sample& sample, RandomStream& random) {
  const int first = random.below(static_cast<int>(sample.corners.size()));
  std::ranges::rotate(sample.corners, sample.corners.begin() + first);
}

/// A regime's sample in another unit of length.
inline void change_unit(Sample& sample, double unit) {
  for (Vec3<double>& v : sample.corners) v *= unit;
  sample.point *= unit;
}

/// A regime's sample moved as a whole.
inline void move_all(Sample& sample, const Vec3<double>& by) {
  for (Vec3<double>& v : sample.corners) v += by;
  sample.point += by;
}

}  // namespace cageproof::validation
