// SPDX-License-Identifier: MIT
#include "cageproof/validation/regime.h"

#include "quad_regime.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

Vec random_in_box(RandomStream& random, double half) {
  return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

Vec random_direction(RandomStream& random) {
  for (;;) {
    const Vec v = random_in_box(random, 1);
    const double length = v.norm();
    if (length > 0.1 && length < 1) return v / length;
  }
}

// Uniform in the ball of radius one. Draws are in statements of their own: the order within an expression is the compiler's.
Vec random_in_ball(RandomStream& random) {
  const double radius = std::cbrt(random.uniform());
  return radius * random_direction(random);
}

double longest_edge(const std::vector<Vec>& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

// Twice the area over the longest edge squared: sqrt(3)/2 for an equilateral triangle.
double aspect(const std::vector<Vec>& t) {
  const double longest = longest_edge(t);
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() / (longest * longest);
}

// A triangle of size one with aspect at least 0.3, at the origin or up to a size away from it.
std::vector<Vec> well_shaped(RandomStream& random) {
  std::vector<Vec> t(3);
  do {
    for (Vec& v : t) v = random_in_box(random, 1);
  } while (longest_edge(t) < 0.5 || aspect(t) < 0.3);
  const double longest = longest_edge(t);
  for (Vec& v : t) v /= longest;
  return t;
}

Vec unit_normal(const std::vector<Vec>& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

Vec centroid(const std::vector<Vec>& t) { return (t[0] + t[1] + t[2]) / 3; }

// Half of the samples put the nearest point of the element at the origin: the only way to be 1e-16 sizes away exactly.
void place_near(Sample& sample, const Vec& foot, const Vec& away, RandomStream& random) {
  if (random.uniform() < 0.5) {
    for (Vec& v : sample.corners) v -= foot;
    sample.point = away;
  } else {
    sample.point = foot + away;
  }
}

double random_sign(RandomStream& random) { return random.uniform() < 0.5 ? -1 : 1; }

// Across an edge: a direction at right angles to it.
Vec across_edge(const std::vector<Vec>& t, int edge, RandomStream& random) {
  const Vec u = (t[(edge + 1) % 3] - t[edge]).normalized();
  const Vec n = unit_normal(t);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return std::cos(angle) * n + std::sin(angle) * u.cross(n);
}

void generic(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = centroid(sample.corners) + random_in_ball(random);
}

void near_face(ElementKind, double distance, RandomStream& random, Sample& sample) {
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

void near_plane(ElementKind, double distance, RandomStream& random, Sample& sample) {
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

void near_edge(ElementKind, double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const auto& t = sample.corners;
  const int e = random.below(3);
  const Vec foot = t[e] + random.uniform(0.05, 0.95) * (t[(e + 1) % 3] - t[e]);
  const Vec away = distance * across_edge(t, e, random);
  place_near(sample, foot, away, random);
}

void near_line(ElementKind, double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const auto& t = sample.corners;
  const int e = random.below(3);
  const double beyond = random.uniform(0.1, 1);
  const Vec foot = t[e] + (random.uniform() < 0.5 ? -beyond : 1 + beyond) * (t[(e + 1) % 3] - t[e]);
  const Vec away = distance * across_edge(t, e, random);
  place_near(sample, foot, away, random);
}

void near_vertex(ElementKind, double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  const Vec foot = sample.corners[random.below(3)];
  const Vec away = distance * random_direction(random);
  place_near(sample, foot, away, random);
}

// Coordinates in 64ths, so that points with hat functions in 16ths are exact, in float too.
std::vector<Vec> dyadic(RandomStream& random) {
  std::vector<Vec> t(3);
  do {
    for (Vec& v : t)
      for (int c = 0; c < 3; ++c) v[c] = (random.below(129) - 64) / 64.0;
  } while (longest_edge(t) < 0.5 || aspect(t) < 0.3);
  return t;
}

// The point with hat functions (16 - i - j, i, j)/16; every other sample is moved by one ulp in one coordinate.
void place_on(Sample& sample, int i, int j, RandomStream& random) {
  const auto& t = sample.corners;
  sample.point = ((16 - i - j) * t[0] + i * t[1] + j * t[2]) / 16;
  if (sample.index % 2 == 0) return;
  double& x = sample.point[random.below(3)];
  // Zero's own neighbour is 1e-324, which no size explains: there the ulp is that of a corner's step.
  const double ulp = std::nextafter(std::max(std::abs(x), 1.0 / 64), 2.0) - std::max(std::abs(x), 1.0 / 64);
  x += random_sign(random) * ulp;
}

void permute_corners(Sample& sample, RandomStream& random) {
  std::ranges::rotate(sample.corners, sample.corners.begin() + random.below(3));
}

void on_face(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = dyadic(random);
  const int i = 1 + random.below(14);
  place_on(sample, i, 1 + random.below(15 - i), random);
}

void on_edge(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = dyadic(random);
  place_on(sample, 1 + random.below(15), 0, random);
  permute_corners(sample, random);
}

void on_vertex(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = dyadic(random);
  place_on(sample, 0, 0, random);
  permute_corners(sample, random);
}

void on_plane(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = dyadic(random);
  const int i = 1 + random.below(16);
  place_on(sample, i, -1 - random.below(16), random);
  permute_corners(sample, random);
}

void on_line(ElementKind, double, RandomStream& random, Sample& sample) {
  sample.corners = dyadic(random);
  place_on(sample, 17 + random.below(16), 0, random);
  permute_corners(sample, random);
}

void far(ElementKind, double distance, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  sample.point = centroid(sample.corners) + distance * random_direction(random);
}

void sliver(ElementKind, double height, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  auto& t = sample.corners;
  const Vec foot = t[0] + random.uniform(0.1, 0.9) * (t[1] - t[0]);
  const Vec up = (t[2] - foot).normalized();
  t[2] = foot + height * (t[1] - t[0]).norm() * up;
  sample.point = centroid(t) + random_in_ball(random);
  permute_corners(sample, random);
}

void needle(ElementKind, double width, RandomStream& random, Sample& sample) {
  sample.corners = well_shaped(random);
  auto& t = sample.corners;
  t[2] = t[1] + width * (t[2] - t[1]);
  sample.point = centroid(t) + random_in_ball(random);
  permute_corners(sample, random);
}

void scaled(ElementKind element, double unit, RandomStream& random, Sample& sample) {
  generic(element, 0, random, sample);
  for (Vec& v : sample.corners) v *= unit;
  sample.point *= unit;
}

void offset(ElementKind element, double distance, RandomStream& random, Sample& sample) {
  generic(element, 0, random, sample);
  const Vec by = distance * random_direction(random);
  for (Vec& v : sample.corners) v += by;
  sample.point += by;
}

std::vector<double> decades(int from, int to, int step = 1) {
  std::vector<double> values;
  for (int exponent = from; step > 0 ? exponent <= to : exponent >= to; exponent += step)
    values.push_back(std::pow(10.0, exponent));
  return values;
}

}  // namespace

const std::vector<Regime>& regimes() {
  static const std::string_view distance = "distance / size";
  static const std::vector<Regime> all{
      {"generic", "", {}, "well-shaped element, point within one size of its centroid", generic, quad::generic},
      {"near-face", distance, decades(-1, -16, -1), "projection inside the element", near_face, quad::near_face},
      {"near-plane", distance, decades(-1, -16, -1), "projection 0.1 to 1 sizes outside the element", near_plane, quad::near_plane},
      {"near-edge", distance, decades(-1, -16, -1), "next to an edge, in its span", near_edge, quad::near_edge},
      {"near-line", distance, decades(-1, -16, -1), "next to an edge's line, 0.1 to 1 lengths beyond its ends", near_line, quad::near_line},
      {"near-vertex", distance, decades(-1, -16, -1), "next to a corner, any direction", near_vertex, quad::near_vertex},
      {"on-face", "", {}, "exactly inside the element, and one ulp off", on_face, quad::on_face},
      {"on-edge", "", {}, "exactly on an edge, and one ulp off", on_edge, quad::on_edge},
      {"on-vertex", "", {}, "exactly at a corner, and one ulp off", on_vertex, quad::on_vertex},
      {"on-plane", "", {}, "exactly in the plane (on the bilinear surface) outside the element, and one ulp off", on_plane, quad::on_plane},
      {"on-line", "", {}, "exactly on an edge's line beyond its ends, and one ulp off", on_line, quad::on_line},
      {"far", distance, decades(1, 8), "many sizes away", far, quad::far},
      {"sliver", "height / size", decades(-1, -10, -1), "cap: one corner close to the opposite edge", sliver, quad::sliver},
      {"needle", "width / size", decades(-1, -10, -1), "one short edge", needle, quad::needle},
      {"scaled", "unit", decades(-100, 100, 20), "generic, in another unit of length", scaled, quad::scaled},
      {"offset", "offset / size", decades(1, 8), "generic, far from the origin", offset, quad::offset},
  };
  return all;
}

const Regime* find_regime(std::string_view name) {
  const auto found = std::ranges::find(regimes(), name, &Regime::name);
  return found == regimes().end() ? nullptr : &*found;
}

namespace {

// The default, a limit or a value in between, so that every row of results has seen them all.
double make_parameter(const Parameter& p, RandomStream& random) {
  const int choice = random.below(4);
  if (choice == 0) return p.preset;
  if (choice == 1 && p.includes_highest) return p.highest;
  if (choice == 2 && p.includes_infinity) return random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL;
  return std::isinf(p.highest) ? p.preset * std::exp2(random.uniform(-3, 3)) : random.uniform(p.lowest, p.highest);
}

}  // namespace

Sample make_sample(const Formula& formula, const Regime& regime, std::uint64_t seed, std::uint64_t index) {
  RandomStream random(seed, fmt::format("{}/{}", formula.name, regime.name), index);
  Sample sample;
  sample.index = index;
  sample.parameter = regime.parameters.empty() ? 0 : regime.parameters[index % regime.parameters.size()];
  if (formula.element == ElementKind::Quad) regime.make_quad(sample.parameter, random, sample);
  else regime.make(formula.element, sample.parameter, random, sample);
  for (const Parameter& p : formula.parameters) sample.parameters.push_back(make_parameter(p, random));
  return sample;
}

}  // namespace cageproof::validation
