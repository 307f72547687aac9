// SPDX-License-Identifier: MIT
// Makes samples of segments in the plane. The inside of a segment corresponds to a triangle's face: potentials jump
// there. Its regimes are therefore `near-face` and `on-face`; its border consists of its ends, so it has no
// `near-edge`. A segment has no plane except its line (`near-line`, `on-line`), and no part of it can be thin.
#include "regimes.h"

#include "../draws.h"
#include "../grid.h"

namespace cageproof::validation::segments {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 2;

// Uniform in the disc of radius one.
Vec random_in_disc(RandomStream& random) {
  const double radius = std::sqrt(random.uniform());
  return radius * random_direction(random, dim);
}

// Makes a segment of length one, at the origin or up to two lengths away from it.
std::vector<Vec> well_shaped(RandomStream& random) {
  std::vector<Vec> s(2);
  do {
    for (Vec& v : s) v = random_in_box(random, 1, dim);
  } while ((s[1] - s[0]).norm() < 0.5);
  const double length = (s[1] - s[0]).norm();
  for (Vec& v : s) v /= length;
  return s;
}

Vec unit_normal(const std::vector<Vec>& s) {
  const Vec along = (s[1] - s[0]).normalized();
  return {along[1], -along[0], 0};
}

Vec middle(const std::vector<Vec>& s) { return (s[0] + s[1]) / 2; }

// Next to the point with this parameter, 0 and 1 at the ends.
void beside(Sample& sample, double parameter, double distance, RandomStream& random) {
  const auto& s = sample.corners;
  const Vec foot = s[0] + parameter * (s[1] - s[0]);
  const Vec away = random_sign(random) * distance * unit_normal(s);
  place_near(sample, foot, away, random);
}

void generic(double, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = middle(sample.corners) + random_in_disc(random);
}

void near_face(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const double parameter = random.uniform(0.05, 0.95);
  beside(sample, parameter, distance, random);
}

void near_line(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const double beyond = random.uniform(0.1, 1);
  const bool before = random.uniform() < 0.5;
  beside(sample, before ? -beyond : 1 + beyond, distance, random);
}

void near_vertex(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const Vec foot = sample.corners[random.below(2)];
  const Vec away = distance * random_direction(random, dim);
  place_near(sample, foot, away, random);
}

// Coordinates in 64ths, so that points with hat functions in 16ths are exact, in float too.
std::vector<Vec> dyadic(RandomStream& random) {
  std::vector<Vec> s(2, Vec::Zero());
  do {
    for (Vec& v : s)
      for (int c = 0; c < dim; ++c) v[c] = (random.below(129) - 64) / 64.0;
  } while ((s[1] - s[0]).norm() < 0.5);
  return s;
}

// Coordinates of many bits, though points with hat functions in 16ths are exact.
std::vector<Vec> many_bits(RandomStream& random, std::uint64_t index) {
  std::vector<Vec> s(2);
  do {
    const GridSteps steps(random, dim, index / 4);
    s[0] = random_origin_on_grid(random, dim);
    s[1] = s[0] + steps.draw(random, 16 * grid_spacing);
  } while ((s[1] - s[0]).norm() < 0.5);
  return s;
}

// The point with hat functions (16 - i, i)/16, either way round; every other sample is moved by one ulp in one
// coordinate, half of them off the line for certain.
void place_on(Sample& sample, int i, RandomStream& random) {
  sample.corners = has_many_bits(sample.index) ? many_bits(random, sample.index) : dyadic(random);
  const bool turned = random.below(2) == 1;
  const Vec &from = sample.corners[turned ? 1 : 0], &to = sample.corners[turned ? 0 : 1];
  const Vec along = (to - from) / 16;
  sample.point = from + i * along;
  if (sample.index % 2 == 0) return;
  if (sample.index % 4 == 1) return move_by_one_ulp(sample, random, dim);
  move_by_one_ulp_along(std::abs(along[0]) < std::abs(along[1]) ? 0 : 1, sample, random);
}

void on_face(double, RandomStream& random, Sample& sample) { place_on(sample, 1 + random.below(15), random); }

void on_vertex(double, RandomStream& random, Sample& sample) { place_on(sample, 0, random); }

void on_line(double, RandomStream& random, Sample& sample) { place_on(sample, 17 + random.below(16), random); }

void far(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = middle(sample.corners) + distance * random_direction(random, dim);
}

void scaled(double unit, RandomStream& random, Sample& sample) {
  generic(0, random, sample);
  change_unit(sample, unit);
}

void offset(double distance, RandomStream& random, Sample& sample) {
  generic(0, random, sample);
  move_all(sample, distance * random_direction(random, dim));
}

constexpr std::array all{SampleMaker{"generic", generic},     SampleMaker{"near-face", near_face},
                         SampleMaker{"near-line", near_line}, SampleMaker{"near-vertex", near_vertex},
                         SampleMaker{"on-face", on_face},     SampleMaker{"on-vertex", on_vertex},
                         SampleMaker{"on-line", on_line},     SampleMaker{"aligned", aligned},
                         SampleMaker{"tiny", tiny},           SampleMaker{"far", far},
                         SampleMaker{"scaled", scaled},       SampleMaker{"offset", offset}};

}  // namespace

std::span<const SampleMaker> regimes() { return all; }

}  // namespace cageproof::validation::segments
