// SPDX-License-Identifier: MIT
// Samples of triangles.
#include "regimes.h"

#include "../draws.h"
#include "../grid.h"

#include <numbers>

namespace cageproof::validation::triangles {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

// Uniform in the ball of radius one.
Vec random_in_ball(RandomStream& random) {
  const double radius = std::cbrt(random.uniform());
  return radius * random_direction(random, dim);
}

// The aspect is twice the area over the longest edge squared: sqrt(3)/2 for an equilateral triangle.
double aspect(const std::vector<Vec>& t) {
  const double longest = longest_edge<double>(t);
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() / (longest * longest);
}

// A triangle of size one with aspect at least 0.3, at the origin or up to a size away from it.
std::vector<Vec> well_shaped(RandomStream& random) {
  std::vector<Vec> t(3);
  do {
    for (Vec& v : t) v = random_in_box(random, 1, dim);
  } while (longest_edge<double>(t) < 0.5 || aspect(t) < 0.3);
  const double longest = longest_edge<double>(t);
  for (Vec& v : t) v /= longest;
  return t;
}

Vec unit_normal(const std::vector<Vec>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

Vec centroid(const std::vector<Vec>& t) { return (t[0] + t[1] + t[2]) / 3; }

// Across an edge: a direction at right angles to it.
Vec across_edge(const std::vector<Vec>& t, int edge, RandomStream& random) {
  const Vec u = (t[(edge + 1) % 3] - t[edge]).normalized();
  const Vec n = unit_normal(t);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return std::cos(angle) * n + std::sin(angle) * u.cross(n);
}

void generic(double, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = centroid(sample.corners) + random_in_ball(random);
}

void near_face(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  double a, b;
  do {
    a = random.uniform(0.05, 0.9);
    b = random.uniform(0.05, 0.9);
  } while (a + b > 0.95);
  const auto& t = sample.corners;
  const Vec foot = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
  const Vec away = random_sign(random) * distance * unit_normal(t);
  place_near(sample, foot, away, random);
}

void near_plane(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const auto& t = sample.corners;
  const int e = random.below(3);
  const Vec edge = t[(e + 1) % 3] - t[e];
  const Vec n = unit_normal(t);
  const double along = random.uniform();
  const double beside = random.uniform(0.1, 1);
  const Vec foot = t[e] + along * edge + beside * edge.normalized().cross(n);
  const Vec away = random_sign(random) * distance * n;
  place_near(sample, foot, away, random);
}

void near_edge(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const auto& t = sample.corners;
  const int e = random.below(3);
  const Vec foot = t[e] + random.uniform(0.05, 0.95) * (t[(e + 1) % 3] - t[e]);
  const Vec away = distance * across_edge(t, e, random);
  place_near(sample, foot, away, random);
}

void near_line(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const auto& t = sample.corners;
  const int e = random.below(3);
  const double beyond = random.uniform(0.1, 1);
  const Vec foot = t[e] + (random.uniform() < 0.5 ? -beyond : 1 + beyond) * (t[(e + 1) % 3] - t[e]);
  const Vec away = distance * across_edge(t, e, random);
  place_near(sample, foot, away, random);
}

void near_vertex(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const Vec foot = sample.corners[random.below(3)];
  const Vec away = distance * random_direction(random, dim);
  place_near(sample, foot, away, random);
}

// Coordinates in 64ths, so that points with hat functions in 16ths are exact, in float too.
std::vector<Vec> dyadic(RandomStream& random) {
  std::vector<Vec> t(3);
  do {
    for (Vec& v : t)
      for (int c = 0; c < 3; ++c) v[c] = (random.below(129) - 64) / 64.0;
  } while (longest_edge<double>(t) < 0.5 || aspect(t) < 0.3);
  return t;
}

// Coordinates of many bits, though points with hat functions in 16ths are exact.
std::vector<Vec> many_bits(RandomStream& random, std::uint64_t index) {
  std::vector<Vec> t(3);
  do {
    const GridSteps steps(random, dim, index / 4);
    t[0] = random_origin_on_grid(random, dim);
    for (int k = 1; k < 3; ++k) t[k] = t[0] + steps.draw(random, 16 * grid_spacing);
  } while (longest_edge<double>(t) < 0.5 || longest_edge<double>(t) > 3 || aspect(t) < 0.3);
  return t;
}

std::vector<Vec> exact(RandomStream& random, std::uint64_t index) {
  return has_many_bits(index) ? many_bits(random, index) : dyadic(random);
}

// The point with hat functions (16 - i - j, i, j)/16, exactly, of corners that exact() makes.
Vec sixteenths(const std::vector<Vec>& t, int i, int j) {
  const Vec along = (t[1] - t[0]) / 16, across = (t[2] - t[0]) / 16;
  return t[0] + i * along + j * across;
}

// Every other sample is moved by one ulp in one coordinate; every other of these off the plane, where formulas that
// diverge on the triangle have values.
void place_on(Sample& sample, int i, int j, RandomStream& random) {
  sample.point = sixteenths(sample.corners, i, j);
  if (sample.index % 2 == 0) return;
  if (sample.index % 4 == 1) return move_by_one_ulp(sample, random, dim);
  int axis = 0;
  const auto& t = sample.corners;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  move_by_one_ulp_along(axis, sample, random);
}

void on_face(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  const int i = 1 + random.below(14);
  place_on(sample, i, 1 + random.below(15 - i), random);
}

void on_edge(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  place_on(sample, 1 + random.below(15), 0, random);
  permute_corners(sample, random);
}

void on_vertex(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  place_on(sample, 0, 0, random);
  permute_corners(sample, random);
}

void on_plane(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  const int i = 1 + random.below(16);
  place_on(sample, i, -1 - random.below(16), random);
  permute_corners(sample, random);
}

// Beyond an end: of 16ths of an edge, more than 16 or less than none.
int beyond_an_end(RandomStream& random) {
  const bool after = random.below(2) == 0;
  const int by = 1 + random.below(16);
  return after ? 16 + by : -by;
}

void on_line(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  place_on(sample, beyond_an_end(random), 0, random);
  permute_corners(sample, random);
}

void far(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = centroid(sample.corners) + distance * random_direction(random, dim);
}

void sliver(double height, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  auto& t = sample.corners;
  const Vec foot = t[0] + random.uniform(0.1, 0.9) * (t[1] - t[0]);
  const Vec up = (t[2] - foot).normalized();
  t[2] = foot + height * (t[1] - t[0]).norm() * up;
  sample.point = centroid(t) + random_in_ball(random);
  permute_corners(sample, random);
}

void needle(double width, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  auto& t = sample.corners;
  t[2] = t[1] + width * (t[2] - t[1]);
  sample.point = centroid(t) + random_in_ball(random);
  permute_corners(sample, random);
}

void scaled(double unit, RandomStream& random, Sample& sample) {
  generic(0, random, sample);
  change_unit(sample, unit);
}

void offset(double distance, RandomStream& random, Sample& sample) {
  generic(0, random, sample);
  move_all(sample, distance * random_direction(random, dim));
}

constexpr std::array all{SampleMaker{"generic", generic},
                         SampleMaker{"near-face", near_face},
                         SampleMaker{"near-plane", near_plane},
                         SampleMaker{"near-edge", near_edge},
                         SampleMaker{"near-line", near_line},
                         SampleMaker{"near-vertex", near_vertex},
                         SampleMaker{"on-face", on_face},
                         SampleMaker{"on-edge", on_edge},
                         SampleMaker{"on-vertex", on_vertex},
                         SampleMaker{"on-plane", on_plane},
                         SampleMaker{"on-line", on_line},
                         SampleMaker{"aligned", aligned},
                         SampleMaker{"tiny", tiny},
                         SampleMaker{"far", far},
                         SampleMaker{"sliver", sliver},
                         SampleMaker{"needle", needle},
                         SampleMaker{"scaled", scaled},
                         SampleMaker{"offset", offset}};

}  // namespace

std::span<const SampleMaker> regimes() { return all; }

}  // namespace cageproof::validation::triangles
