// SPDX-License-Identifier: MIT
#include "mutations.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

int vertex_count(const Sample& s) { return static_cast<int>(s.corners.size()) + 1; }

// Vertex k: the corners, then the point.
Vec& vertex(Sample& s, int k) { return k + 1 < vertex_count(s) ? s.corners[k] : s.point; }

// Half of all moves are the point's.
Vec& random_vertex(Sample& s, RandomStream& random) {
  return random.below(2) == 0 ? s.point : vertex(s, random.below(vertex_count(s)));
}

double size_of(const Sample& s) {
  double size = 0;
  for (std::size_t i = 0; i < s.corners.size(); ++i)
    size = std::max(size, (s.corners[(i + 1) % s.corners.size()] - s.corners[i]).norm());
  return size;
}

double random_sign(RandomStream& random) { return random.below(2) == 0 ? -1 : 1; }

// +-10^x, x uniform.
double random_step(RandomStream& random, double lowest, double highest) {
  const double sign = random_sign(random);
  return sign * std::pow(10.0, random.uniform(lowest, highest));
}

// 2^k, k != 0: mostly small, up to twelve decades.
double power_of_two(RandomStream& random) {
  const int most = random.below(4) == 0 ? 40 : 4;
  const int k = 1 + random.below(most);
  return std::ldexp(1.0, random.below(2) == 0 ? -k : k);
}

struct Edge {
  Vec start, along;  // not normalised
};

Edge random_edge(const Sample& s, RandomStream& random) {
  const std::size_t e = random.below(static_cast<int>(s.corners.size()));
  return {s.corners[e], s.corners[(e + 1) % s.corners.size()] - s.corners[e]};
}

Vec normal_of(const Sample& s) { return (s.corners[1] - s.corners[0]).cross(s.corners[2] - s.corners[0]).normalized(); }

// The nearest point of a random corner, edge's line or plane, where foot and away are those of `from`.
Vec foot_on_feature(const Sample& s, const Vec& from, RandomStream& random) {
  const int kind = random.below(3);
  const Edge edge = random_edge(s, random);
  if (kind == 0) return edge.start;
  if (kind == 1) return edge.start + (from - edge.start).dot(edge.along) / edge.along.squaredNorm() * edge.along;
  const Vec n = normal_of(s);
  return from - (from - edge.start).dot(n) * n;
}

void step_by_size(const Formula&, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  v[random.below(3)] += size_of(s) * random_step(random, -17, 0);
}

void step_by_itself(const Formula&, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  v[random.below(3)] *= 1 + random_step(random, -16, 0);
}

void one_ulp(const Formula&, Sample& s, RandomStream& random) {
  double& x = random_vertex(s, random)[random.below(3)];
  const double towards = random_sign(random) * HUGE_VAL;
  // Zero's own neighbour is 1e-324, which no size explains.
  if (x == 0) return;
  for (int k = 1 + random.below(3); k > 0; --k) x = std::nextafter(x, towards);
}

void snap_coordinate(const Formula&, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  const int c = random.below(3), other = random.below(vertex_count(s) + 1);
  v[c] = other == vertex_count(s) ? 0.0 : vertex(s, other)[c];
}

// Fewer bits: where products become exact, and where coordinates meet.
void round_coordinate(const Formula&, Sample& s, RandomStream& random) {
  double& x = random_vertex(s, random)[random.below(3)];
  const int bits = random.below(50);
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  x = std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

void along_edge(const Formula&, Sample& s, RandomStream& random) {
  const Edge edge = random_edge(s, random);
  random_vertex(s, random) += random_step(random, -16, 0.5) * edge.along;
}

void across_edge(const Formula&, Sample& s, RandomStream& random) {
  const Vec beside = random_edge(s, random).along.cross(normal_of(s));
  random_vertex(s, random) += random_step(random, -16, 0.5) * beside;
}

void off_plane(const Formula&, Sample& s, RandomStream& random) {
  const Vec n = size_of(s) * normal_of(s);
  random_vertex(s, random) += random_step(random, -16, 0.5) * n;
}

void scale_distance(const Formula&, Sample& s, RandomStream& random) {
  const Vec foot = foot_on_feature(s, s.point, random);
  s.point = foot + power_of_two(random) * (s.point - foot);
}

void onto_feature(const Formula&, Sample& s, RandomStream& random) { s.point = foot_on_feature(s, s.point, random); }

// The foot at the origin: there doubles carry the distance to full precision.
void foot_to_origin(const Formula&, Sample& s, RandomStream& random) {
  const Vec foot = foot_on_feature(s, s.point, random);
  for (Vec& corner : s.corners) corner -= foot;
  s.point -= foot;
}

void shift_all(const Formula&, Sample& s, RandomStream& random) {
  const double length = size_of(s) * random_step(random, -3, 8);
  const Vec by = length * Vec(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  for (Vec& corner : s.corners) corner += by;
  s.point += by;
}

void scale_all(const Formula&, Sample& s, RandomStream& random) {
  const double factor = random.below(8) == 0 ? std::ldexp(1.0, random.below(601) - 300) : power_of_two(random);
  for (Vec& corner : s.corners) corner *= factor;
  s.point *= factor;
}

// One corner towards, or away from, the opposite edge (sliver) or the next corner (needle).
void change_aspect(const Formula&, Sample& s, RandomStream& random) {
  const std::size_t n = s.corners.size(), k = random.below(static_cast<int>(n));
  Vec& corner = s.corners[k];
  const Vec& a = s.corners[(k + 1) % n];
  const Vec along = s.corners[(k + n - 1) % n] - a;
  const Vec foot = random.below(2) == 0 ? a : Vec(a + (corner - a).dot(along) / along.squaredNorm() * along);
  corner = foot + power_of_two(random) * (corner - foot);
}

void turn_over(const Formula&, Sample& s, RandomStream& random) {
  const int kind = random.below(3);
  if (kind == 0) return std::ranges::reverse(s.corners), void();
  if (kind == 1) return std::ranges::rotate(s.corners, s.corners.begin() + 1), void();
  const int a = random.below(3), b = (a + 1) % 3;
  for (Vec& corner : s.corners) std::swap(corner[a], corner[b]);
  std::swap(s.point[a], s.point[b]);
}

void point_anew(const Formula&, Sample& s, RandomStream& random) {
  const double a = random.uniform(-0.5, 1.5), b = random.uniform(-0.5, 1.5);
  const double height = size_of(s) * random_step(random, -18, 1);
  s.point = s.corners[0] + a * (s.corners[1] - s.corners[0]) + b * (s.corners[2] - s.corners[0]);
  if (random.below(4) != 0) s.point += height * normal_of(s);
}

void change_parameter(const Formula& formula, Sample& s, RandomStream& random) {
  if (formula.parameters.empty()) return;
  const int k = random.below(static_cast<int>(formula.parameters.size()));
  const Parameter& p = formula.parameters[k];
  double& x = s.parameters[k];
  switch (random.below(5)) {
    case 0: x = p.preset; break;
    case 1: x = p.includes_infinity ? random_sign(random) * HUGE_VAL : p.highest; break;
    case 2: x = (std::isfinite(p.highest) ? p.highest : x) * (1 - std::pow(10.0, random.uniform(-16, 0))); break;
    case 3: x = (std::isfinite(p.lowest) ? p.lowest : x) * (1 - std::pow(10.0, random.uniform(-16, 0))); break;
    default: x *= 1 + random_step(random, -16, 1); break;
  }
}

constexpr std::array all{
    Mutation{"step by size", step_by_size},         Mutation{"step by itself", step_by_itself},
    Mutation{"one ulp", one_ulp},                   Mutation{"snap coordinate", snap_coordinate},
    Mutation{"round coordinate", round_coordinate}, Mutation{"along edge", along_edge},
    Mutation{"across edge", across_edge},           Mutation{"off plane", off_plane},
    Mutation{"scale distance", scale_distance},     Mutation{"onto feature", onto_feature},
    Mutation{"foot to origin", foot_to_origin},     Mutation{"shift all", shift_all},
    Mutation{"scale all", scale_all},               Mutation{"change aspect", change_aspect},
    Mutation{"turn over", turn_over},               Mutation{"point anew", point_anew},
    Mutation{"change parameter", change_parameter}};

}  // namespace

std::span<const Mutation> mutations() { return all; }

}  // namespace cageproof::validation
