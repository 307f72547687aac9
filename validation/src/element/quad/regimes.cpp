// SPDX-License-Identifier: MIT
// Makes samples of bilinear quads: planar, twisted or strongly twisted by turns.
#include "regimes.h"

#include "../draws.h"
#include "../grid.h"

#include "cageproof/core/geometry/quad_geometry.h"

#include <numbers>

namespace cageproof::validation::quads {
namespace {

using Vec = Vec3<double>;
constexpr int dim = 3;

// Uniform in the ball of radius one.
Vec random_in_ball(RandomStream& random) {
  const double radius = std::cbrt(random.uniform());
  return radius * random_direction(random, dim);
}

bool valid(const std::vector<Vec>& q) { return !invalid_because({q[0], q[1], q[2], q[3]}); }

// Alternate corners are lifted by this part of the size: flat, twisted, strongly twisted.
double random_twist(RandomStream& random, std::uint64_t index) {
  if (index % 3 == 0) return 0;
  return index % 3 == 1 ? random.uniform(0.03, 0.3) : random.uniform(0.3, 0.8);
}

bool has_short_side(std::uint64_t index) { return index / 3 % 4 == 3; }

// A unit square with its corners moved in its plane and lifted by turns, in axes of its own.
std::vector<Vec> in_own_axes(RandomStream& random, std::uint64_t index) {
  const double twist = random_twist(random, index);
  static constexpr double x[4]{-0.5, 0.5, 0.5, -0.5}, y[4]{-0.5, -0.5, 0.5, 0.5};
  std::vector<Vec> q(4);
  for (int k = 0; k < 4; ++k) {
    const double dx = random.uniform(-0.2, 0.2), dy = random.uniform(-0.2, 0.2);
    const double lift = twist == 0 ? 0 : twist * (k % 2 == 0 ? 0.5 : -0.5) * random.uniform(0.7, 1);
    q[k] = Vec(x[k] + dx, y[k] + dy, lift);
  }
  // One side in four quads is short, down to a thousandth: two singularities of the line form next to each other.
  if (has_short_side(index)) q[2] = q[1] + std::pow(10.0, -random.uniform(0.5, 3)) * (q[2] - q[1]);
  return q;
}

// A valid quad of size one, anywhere within a size of the origin.
std::vector<Vec> well_shaped(RandomStream& random, std::uint64_t index) {
  std::vector<Vec> q;
  do {
    q = in_own_axes(random, index);
    const double longest = longest_edge<double>(q);
    const Vec n = random_direction(random, dim);
    const Vec a = n.cross(random_direction(random, dim)).normalized(), b = n.cross(a),
              by = random_in_box(random, 0.5, dim);
    for (Vec& v : q) v = Vec((v[0] * a + v[1] * b + v[2] * n) / longest) + by;
  } while (index % 3 != 0 && !valid(q));  // rounding may twist a flat one, which stays convex
  return q;
}

Vec at(const std::vector<Vec>& q, double u, double v) {
  return (1 - v) * ((1 - u) * q[0] + u * q[1]) + v * (u * q[2] + (1 - u) * q[3]);
}

Vec normal_at(const std::vector<Vec>& q, double u, double v) {
  const Vec along = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]), across = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return along.cross(across).normalized();
}

Vec centroid(const std::vector<Vec>& q) { return (q[0] + q[1] + q[2] + q[3]) / 4; }

Vec across_edge(const std::vector<Vec>& q, int edge, RandomStream& random) {
  const Vec u = (q[(edge + 1) % 4] - q[edge]).normalized();
  const Vec n = u.cross(random_direction(random, dim)).normalized();
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return std::cos(angle) * n + std::sin(angle) * u.cross(n);
}

// Coordinates in 64ths, so that points with parameters in eighths are exact, in float too; flat ones are parallelograms
// or trapezoids.
std::vector<Vec> dyadic(RandomStream& random, std::uint64_t index) {
  const auto rounded = [](Vec v) {
    for (int c = 0; c < 3; ++c) v[c] = std::round(64 * v[c]) / 64;
    return v;
  };
  std::vector<Vec> q;
  do {
    q = well_shaped(random, index);
    for (Vec& v : q) v = rounded(v);
    if (index % 3 == 0) q[2] = q[3] + (random.uniform() < 0.5 ? 1.0 : 0.5) * (q[1] - q[0]);
  } while (!valid(q));
  return q;
}

// Coordinates of many bits, though points with parameters in eighths are exact; flat ones are parallelograms or
// trapezoids.
std::vector<Vec> many_bits(RandomStream& random, std::uint64_t index) {
  const bool flat = index % 3 == 0;
  std::vector<Vec> q(4);
  for (;;) {
    const GridSteps steps(random, dim, flat ? index / 6 : 0), any(random, dim, 0);
    const Vec along = steps.draw(random, 128 * grid_spacing), across = steps.draw(random, 128 * grid_spacing);
    Vec twist = any.draw(random, 256 * grid_spacing) / (index % 3 == 1 ? 4 : 1);
    if (flat) twist = random.below(2) == 0 ? Vec(Vec::Zero()) : Vec(-along / 2);
    const double a = along.norm(), b = across.norm();
    if (std::min(a, b) < 0.5 || std::max(a, b) > 1.5 || along.cross(across).norm() < 0.5 * a * b) continue;
    q[0] = random_origin_on_grid(random, dim);
    q[1] = q[0] + along;
    q[2] = q[0] + (along + across + twist);
    q[3] = q[0] + across;
    if (valid(q)) return q;
  }
}

std::vector<Vec> exact(RandomStream& random, std::uint64_t index) {
  return has_many_bits(index) ? many_bits(random, index) : dyadic(random, index);
}

// The point with these parameters in eighths, exactly, of corners that exact() makes.
Vec exactly_at(const std::vector<Vec>& q, double u, double v) {
  const Vec along = q[1] - q[0], across = q[3] - q[0], twist = q[2] - q[1] - across;
  return q[0] + (u * along + v * across + u * v * twist);
}

// Every other sample is moved by one ulp in one coordinate.
void place_on(Sample& sample, double u, double v, RandomStream& random) {
  sample.point = exactly_at(sample.corners, u, v);
  if (sample.index / 3 % 2 == 0) return;
  move_by_one_ulp(sample, random, dim);
}

// In eighths, within (0, 1).
double inner_eighth(RandomStream& random) { return (1 + random.below(7)) / 8.0; }

void generic(double, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  const auto& q = sample.corners;
  sample.point = centroid(q) + random_in_ball(random);
  // The point is about as far from the short side as that side is long.
  if (has_short_side(sample.index))
    sample.point = (q[1] + q[2]) / 2 + 2 * (q[2] - q[1]).norm() * random_in_ball(random);
}

void near_face(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  const double u = random.uniform(0.05, 0.95), v = random.uniform(0.05, 0.95);
  const Vec foot = at(sample.corners, u, v);
  const Vec away = random_sign(random) * distance * normal_at(sample.corners, u, v);
  place_near(sample, foot, away, random);
}

void near_plane(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  permute_corners(sample, random);
  const double u = random.uniform(), v = -random.uniform(0.1, 1);
  const Vec foot = at(sample.corners, u, v);
  const Vec away = random_sign(random) * distance * normal_at(sample.corners, u, v);
  place_near(sample, foot, away, random);
}

void near_edge(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  const auto& q = sample.corners;
  const int e = random.below(4);
  const Vec foot = q[e] + random.uniform(0.05, 0.95) * (q[(e + 1) % 4] - q[e]);
  const Vec away = distance * across_edge(q, e, random);
  place_near(sample, foot, away, random);
}

void near_line(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  const auto& q = sample.corners;
  const int e = random.below(4);
  const double beyond = random.uniform(0.1, 1);
  const Vec foot = q[e] + (random.uniform() < 0.5 ? -beyond : 1 + beyond) * (q[(e + 1) % 4] - q[e]);
  const Vec away = distance * across_edge(q, e, random);
  place_near(sample, foot, away, random);
}

void near_vertex(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  const Vec foot = sample.corners[random.below(4)];
  const Vec away = distance * random_direction(random, dim);
  place_near(sample, foot, away, random);
}

void on_face(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  const double u = inner_eighth(random);
  place_on(sample, u, inner_eighth(random), random);
}

void on_edge(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  permute_corners(sample, random);
  place_on(sample, inner_eighth(random), 0, random);
}

void on_vertex(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  permute_corners(sample, random);
  place_on(sample, 0, 0, random);
}

void on_plane(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  permute_corners(sample, random);
  const double u = inner_eighth(random);
  place_on(sample, u, -inner_eighth(random), random);
}

void on_line(double, RandomStream& random, Sample& sample) {
  sample.corners = exact(random, sample.index);
  permute_corners(sample, random);
  const bool after = random.below(2) == 0;
  const double by = inner_eighth(random);
  place_on(sample, after ? 1 + by : -by, 0, random);
}

void far(double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  sample.point = centroid(sample.corners) + distance * random_direction(random, dim);
}

// Flat: thin quads fold over with the least twist.
void sliver(double height, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, 0);
  auto& q = sample.corners;
  q[3] = q[0] + height * (q[3] - q[0]);
  q[2] = q[1] + height * (q[2] - q[1]);
  sample.point = centroid(q) + random_in_ball(random);
  permute_corners(sample, random);
}

// One side is short, seen from all around or from as near as it is long; or three corners are close to each other, seen
// from there: opposite sides differ as much as a quad's can.
void needle(double width, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random, sample.index);
  auto& q = sample.corners;
  const std::uint64_t kind = sample.index / 3 % 3;
  if (kind == 0) {
    q[2] = q[3] + width * (q[2] - q[3]);
    sample.point = centroid(q) + random_in_ball(random);
  } else if (kind == 1) {
    q[2] = q[3] + width * (q[2] - q[3]);
    sample.point = (q[2] + q[3]) / 2 + 2 * width * random_in_ball(random);
  } else {
    for (const int k : {0, 2}) q[k] = q[1] + width * (q[k] - q[1]);
    const Vec in_plane = random.uniform(-1, 1) * (q[0] - q[1]) + random.uniform(-1, 1) * (q[2] - q[1]);
    sample.point = random.below(2) == 0 ? Vec(q[1] + in_plane) : Vec(q[1] + 2 * width * random_in_ball(random));
  }
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

}  // namespace cageproof::validation::quads
