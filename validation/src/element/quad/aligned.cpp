// SPDX-License-Identifier: MIT
// Quads in small integers, and points at exact places of them.
#include "regimes.h"

#include "../draws.h"

#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>
#include <array>

namespace cageproof::validation::quads {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

Vec at(const std::vector<Vec>& q, double u, double v) {
  return (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * (u * q[2] + (1 - u) * q[3]);
}

// In eighths, within (0, 1).
double inner_eighth(RandomStream& random) { return (1 + random.below(7)) / 8.0; }

// Over the middle of a square or rectangle of two axes, of a square across all axes, or of a saddle.
void over_centre(double distance, RandomStream& random, Sample& sample) {
  const int flat = random.below(dim);
  Vec a = unit_along((flat + 1) % dim), b = unit_along((flat + 2) % dim), normal = unit_along(flat), lift = Vec::Zero();
  switch (random.below(4)) {
    case 0: break;
    case 1: a *= 2; break;
    case 2: lift = 0.5 * normal; break;
    default:
      a = {1, -1, 0.5};
      b = {0.5, 1, 1};
      normal = {-2, -1, 2};
  }
  sample.corners = {Vec::Zero(), a + lift, a + b, b + lift};
  if (random.below(2) == 1) std::swap(sample.corners[1], sample.corners[3]);
  permute_corners(sample, random);
  const Vec up = distance * normal;
  place_exactly(sample, type_of(ElementKind::Quad), at(sample.corners, 0.5, 0.5), random,
                [&] { return Vec(random_sign(random) * up); });
}

// Off a flat quad in small integers that folds over or crosses itself, every other one with two corners in one: off a
// corner, where both sheets are as near, a point of the crease, or any.
void over_fold(double distance, RandomStream& random, Sample& sample) {
  const int flat = random.below(dim);
  auto& q = sample.corners;
  q.resize(4);
  std::array<double, 4> turn{};  // the normals at the corners
  const bool in_one = random.below(2) == 0;
  do {
    for (Vec& v : q) v = random_integers(random, 1, dim, flat);
    if (in_one) q[3] = q[1];
    for (int k = 0; k < 4; ++k) turn[k] = (q[(k + 1) % 4] - q[k]).cross(q[(k + 3) % 4] - q[k])[flat];
  } while (!(turn[0] * turn[2] < 0 || turn[1] * turn[3] < 0));
  double u = inner_eighth(random), v = inner_eighth(random);
  switch (random.below(3)) {
    case 0: u = v = random.below(2); break;
    case 1:
      // The normal turn[0] + u (turn[1] - turn[0]) + v (turn[3] - turn[0]) is zero on the crease.
      if (turn[3] != turn[0]) v = std::clamp((turn[0] + u * (turn[1] - turn[0])) / (turn[0] - turn[3]), 0., 1.);
      else u = std::clamp(turn[0] / (turn[0] - turn[1]), 0., 1.);
      break;
    default: break;
  }
  place_exactly(sample, type_of(ElementKind::Quad), at(q, u, v), random,
                [&] { return Vec(distance * random_step(random, dim)); });
}

}  // namespace

std::vector<Vec> integral(RandomStream& random, std::uint64_t turn, int flat) {
  std::vector<Vec> q(4);
  if (turn % 3 == 0) {
    const Vec a = unit_along((flat + 1) % 3), b = unit_along((flat + 2) % 3);
    q = {Vec::Zero(), a, a + b, b};
  } else {
    const bool in_plane = turn % 3 == 1;
    do {
      for (Vec& v : q) v = random_integers(random, in_plane ? 2 : 1, dim, in_plane ? flat : -1);
    } while (invalid_because({q[0], q[1], q[2], q[3]}));
  }
  if (random.below(2) == 1) std::swap(q[1], q[3]);
  return q;
}

Vec exact_foot(const std::vector<Vec>& q, Feature feature, RandomStream& random) {
  double u = 0, v = 0;
  switch (feature) {
    case Feature::Face:
      u = inner_eighth(random);
      v = inner_eighth(random);
      break;
    case Feature::Edge: u = inner_eighth(random); break;
    case Feature::Vertex: break;
    case Feature::Plane:
      u = inner_eighth(random);
      v = -inner_eighth(random);
      break;
    case Feature::Line: u = random.below(2) == 0 ? 1 + inner_eighth(random) : -inner_eighth(random); break;
  }
  return at(q, u, v);
}

// Off a point of the face, a side, a corner, or the surface or a side's line beyond; every fourth over a middle, and
// as many off a fold.
void aligned(double distance, RandomStream& random, Sample& sample) {
  if (sample.index % 4 == 1) return over_fold(distance, random, sample);
  if (sample.index % 4 == 3) return over_centre(distance, random, sample);
  const int flat = random.below(dim);
  sample.corners = integral(random, sample.index, flat);
  permute_corners(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_exactly(sample, type_of(ElementKind::Quad), foot, random,
                [&] { return Vec(distance * random_step(random, dim)); });
}

}  // namespace cageproof::validation::quads
