// SPDX-License-Identifier: MIT
// Triangles in small integers, and points at exact places of them.
#include "regimes.h"

#include "../draws.h"

namespace cageproof::validation::triangles {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

// Twice the area over the longest edge squared is at least 0.3.
bool well_shaped(const std::vector<Vec>& t) {
  const double longest = longest_edge<double>(t);
  return longest > 0 && (t[1] - t[0]).cross(t[2] - t[0]).norm() >= 0.3 * longest * longest;
}

// A triangle of equal sides, of a right angle between equal legs, or on a circle of integers, and the centre of gravity
// or of the circle through its corners: all exact.
struct Symmetric {
  std::vector<Vec> corners;
  Vec centre;
  Vec normal;  // of no particular length
};

Symmetric equilateral(RandomStream& random) {
  Symmetric found{{}, Vec::Zero(), Vec::Zero()};
  for (int c = 0; c < dim; ++c) {
    const Vec along = random_sign(random) * unit_along(c);
    found.corners.emplace_back(1.5 * along);
    found.centre += 0.5 * along;
    found.normal += along;
  }
  return found;
}

Symmetric right_angled(RandomStream& random, int flat) {
  const Vec a = random_sign(random) * unit_along((flat + 1) % dim);
  const Vec b = random_sign(random) * unit_along((flat + 2) % dim);
  const Vec centre = (random.below(2) == 0 ? 1.0 : 1.5) * (a + b);
  return {{Vec::Zero(), 3 * a, 3 * b}, centre, unit_along(flat)};
}

// Makes corners on a circle of radius 15/8: their coordinates are eighths, and so is a third of their sums.
Symmetric on_circle(RandomStream& random, int flat) {
  static constexpr std::array<std::array<int, 2>, 3> quarter{{{5, 0}, {4, 3}, {3, 4}}};
  std::vector<Vec> t(3);
  do {
    for (Vec& v : t) {
      const auto [x, y] = quarter[random.below(3)];
      const double a = random_sign(random) * x;
      const double b = random_sign(random) * y;
      const bool turned = random.below(2) == 1;
      v = (turned ? b : a) * 0.375 * unit_along((flat + 1) % dim) +
          (turned ? a : b) * 0.375 * unit_along((flat + 2) % dim);
    }
  } while (!well_shaped(t));
  const Vec centroid = (t[0] + t[1] + t[2]) / 3;
  return {t, random.below(2) == 0 ? Vec(Vec::Zero()) : centroid, unit_along(flat)};
}

Symmetric symmetric(RandomStream& random, int flat) {
  switch (random.below(3)) {
    case 0: return equilateral(random);
    case 1: return right_angled(random, flat);
    default: return on_circle(random, flat);
  }
}

// Over the centre.
void over_centre(double distance, RandomStream& random, Sample& sample) {
  auto [corners, centre, normal] = symmetric(random, random.below(dim));
  if (random.below(2) == 1) std::swap(corners[1], corners[2]);
  sample.corners = std::move(corners);
  const Vec up = distance * normal;
  place_exactly(sample, type_of(ElementKind::Triangle), centre, random, [&] { return Vec(random_sign(random) * up); });
}

}  // namespace

std::vector<Vec> integral(RandomStream& random, std::uint64_t turn, int flat) {
  std::vector<Vec> t(3);
  if (turn % 3 == 0) {
    t = {Vec::Zero(), unit_along((flat + 1) % 3), unit_along((flat + 2) % 3)};
  } else {
    const bool in_plane = turn % 3 == 1;
    do {
      for (Vec& v : t) v = random_integers(random, in_plane ? 2 : 1, dim, in_plane ? flat : -1);
    } while (!well_shaped(t));
  }
  if (random.below(2) == 1) std::swap(t[1], t[2]);
  return t;
}

Vec exact_foot(const std::vector<Vec>& t, Feature feature, RandomStream& random) {
  int i = 0, j = 0;  // hat functions in 16ths
  switch (feature) {
    case Feature::Face:
      i = 1 + random.below(14);
      j = 1 + random.below(15 - i);
      break;
    case Feature::Edge: i = 1 + random.below(15); break;
    case Feature::Vertex: break;
    case Feature::Plane:
      i = 1 + random.below(16);
      j = -1 - random.below(16);
      break;
    case Feature::Line: i = random.below(2) == 0 ? 17 + random.below(16) : -1 - random.below(16); break;
  }
  return ((16 - i - j) * t[0] + i * t[1] + j * t[2]) / 16;
}

// Off a point of the face, an edge, a corner, or the plane or an edge's line beyond; every fourth over a centre.
void aligned(double distance, RandomStream& random, Sample& sample) {
  if (sample.index % 4 == 3) return over_centre(distance, random, sample);
  const int flat = random.below(dim);
  sample.corners = integral(random, sample.index, flat);
  permute_corners(sample, random);
  const Vec foot = exact_foot(sample.corners, static_cast<Feature>(random.below(5)), random);
  place_exactly(sample, type_of(ElementKind::Triangle), foot, random,
                [&] { return Vec(distance * random_step(random, dim)); });
}

}  // namespace cageproof::validation::triangles
