// SPDX-License-Identifier: MIT
#include "sampling/mutations.h"

#include "element/element_sampling.h"
#include "element/tiny.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

// Draws stand in statements of their own, since C++ leaves the order of function arguments and of most operands open.

int vertex_count(const Sample& s) { return static_cast<int>(s.corners.size()) + 1; }

// Vertex k: the corners, then the point.
Vec& vertex(Sample& s, int k) { return k + 1 < vertex_count(s) ? s.corners[k] : s.point; }

// Half of all moves are the point's.
Vec& random_vertex(Sample& s, RandomStream& random) {
  return random.below(2) == 0 ? s.point : vertex(s, random.below(vertex_count(s)));
}

// One of a vertex's coordinates, in the element's space.
double& random_coordinate(const Formula& formula, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  return v[random.below(formula.dim())];
}

double size_of(const Sample& s) { return longest_edge<double>(s.corners); }

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

const SearchShape& shape_of(const Formula& formula) { return sampling_of(formula.element).search; }

// The normal of a flat element; for a bilinear quad the direction of its area.
Vec normal_of(const Formula& formula, const Sample& s) {
  return type_of(formula.element).extent(s.corners).normalized();
}

// The nearest point of a random corner, edge's line or the surface.
Vec foot_on_feature(const Formula& formula, const Sample& s, RandomStream& random) {
  const int kind = random.below(3);
  const Edge edge = random_edge(s, random);
  if (kind == 0) return edge.start;
  if (kind == 1) return edge.start + (s.point - edge.start).dot(edge.along) / edge.along.squaredNorm() * edge.along;
  return shape_of(formula).foot(s.corners, s.point);
}

void step_by_size(const Formula& formula, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  const double step = size_of(s) * random_step(random, -17, 0);
  v[random.below(formula.dim())] += step;
}

void step_by_itself(const Formula& formula, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  const double factor = 1 + random_step(random, -16, 0);
  v[random.below(formula.dim())] *= factor;
}

void one_ulp(const Formula& formula, Sample& s, RandomStream& random) {
  double& x = random_coordinate(formula, s, random);
  const double towards = random_sign(random) * HUGE_VAL;
  // One ulp off zero is a denormal (5e-324), far below any element's size, so it is left out.
  if (x == 0) return;
  for (int k = 1 + random.below(3); k > 0; --k) x = std::nextafter(x, towards);
}

void snap_coordinate(const Formula& formula, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  const int c = random.below(formula.dim()), other = random.below(vertex_count(s) + 1);
  v[c] = other == vertex_count(s) ? 0.0 : vertex(s, other)[c];
}

void tiny_coordinate(const Formula& formula, Sample& s, RandomStream& random) {
  double& x = random_coordinate(formula, s, random);
  const double sign = random_sign(random);
  x = sign * tiny_distance(random);
}

// Fewer bits: where products become exact, and where coordinates meet.
void round_coordinate(const Formula& formula, Sample& s, RandomStream& random) {
  double& x = random_coordinate(formula, s, random);
  const int bits = random.below(50);
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  x = std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

// Into a plane (in the plane onto a line) of the axes: the corners, half of the time with the point.
void flatten(const Formula& formula, Sample& s, RandomStream& random) {
  const int c = random.below(formula.dim()), height = random.below(vertex_count(s) + 1);
  const double x = height == vertex_count(s) ? 0.0 : vertex(s, height)[c];
  for (Vec& corner : s.corners) corner[c] = x;
  if (random.below(2) == 0) s.point[c] = x;
}

// An edge, or the way from a corner to the point, along an axis.
void align(const Formula& formula, Sample& s, RandomStream& random) {
  Vec& v = random_vertex(s, random);
  const int from = random.below(static_cast<int>(s.corners.size())), axis = random.below(formula.dim());
  const double kept = v[axis];
  v = s.corners[from];
  v[axis] = kept;
}

// All coordinates to few bits of the size.
void round_all(const Formula&, Sample& s, RandomStream& random) {
  const double size = size_of(s);
  if (!(size > 0) || !std::isfinite(size)) return;
  const double unit = std::ldexp(1.0, std::ilogb(size) - 1 - random.below(8));
  for (int k = 0; k < vertex_count(s); ++k)
    for (double& x : vertex(s, k)) x = unit * std::nearbyint(x / unit);
}

void along_edge(const Formula&, Sample& s, RandomStream& random) {
  const Edge edge = random_edge(s, random);
  const double step = random_step(random, -16, 0.5);
  random_vertex(s, random) += step * edge.along;
}

void across_edge(const Formula& formula, Sample& s, RandomStream& random) {
  const Vec beside = shape_of(formula).across(s.corners, random_edge(s, random).along);
  const double step = random_step(random, -16, 0.5);
  random_vertex(s, random) += step * beside;
}

void off_surface(const Formula& formula, Sample& s, RandomStream& random) {
  const Vec n = size_of(s) * normal_of(formula, s);
  const double step = random_step(random, -16, 0.5);
  random_vertex(s, random) += step * n;
}

void scale_distance(const Formula& formula, Sample& s, RandomStream& random) {
  const Vec foot = foot_on_feature(formula, s, random);
  s.point = foot + power_of_two(random) * (s.point - foot);
}

void onto_feature(const Formula& formula, Sample& s, RandomStream& random) {
  s.point = foot_on_feature(formula, s, random);
}

// The foot at the origin: there doubles carry the distance to full precision.
void foot_to_origin(const Formula& formula, Sample& s, RandomStream& random) {
  const Vec foot = foot_on_feature(formula, s, random);
  for (Vec& corner : s.corners) corner -= foot;
  s.point -= foot;
}

void shift_all(const Formula& formula, Sample& s, RandomStream& random) {
  const double length = size_of(s) * random_step(random, -3, 8);
  Vec by = Vec::Zero();
  for (int c = 0; c < formula.dim(); ++c) by[c] = random.uniform(-1, 1);
  by *= length;
  for (Vec& corner : s.corners) corner += by;
  s.point += by;
}

void scale_all(const Formula&, Sample& s, RandomStream& random) {
  const double factor = random.below(8) == 0 ? std::ldexp(1.0, random.below(2001) - 1000) : power_of_two(random);
  for (Vec& corner : s.corners) corner *= factor;
  s.point *= factor;
}

// One corner towards, or away from, the line of its neighbours (sliver) or the next corner (needle).
void change_aspect(const Formula&, Sample& s, RandomStream& random) {
  const std::size_t n = s.corners.size(), k = random.below(static_cast<int>(n));
  Vec& corner = s.corners[k];
  const Vec& a = s.corners[(k + 1) % n];
  const Vec along = s.corners[(k + n - 1) % n] - a;
  const bool needle = random.below(2) == 0 || along == Vec::Zero();
  const Vec foot = needle ? a : Vec(a + (corner - a).dot(along) / along.squaredNorm() * along);
  corner = foot + power_of_two(random) * (corner - foot);
}

void turn_over(const Formula& formula, Sample& s, RandomStream& random) {
  const int kind = random.below(3);
  if (kind == 0) return std::ranges::reverse(s.corners), void();
  if (kind == 1) return std::ranges::rotate(s.corners, s.corners.begin() + 1), void();
  const int a = random.below(formula.dim()), b = (a + 1) % formula.dim();
  for (Vec& corner : s.corners) std::swap(corner[a], corner[b]);
  std::swap(s.point[a], s.point[b]);
}

void point_anew(const Formula& formula, Sample& s, RandomStream& random) {
  const double a = random.uniform(-0.5, 1.5), b = random.uniform(-0.5, 1.5);
  const double height = size_of(s) * random_step(random, -18, 1);
  s.point = shape_of(formula).at(s.corners, a, b);
  if (random.below(4) != 0) s.point += height * normal_of(formula, s);
}

void change_parameter(const Formula& formula, Sample& s, RandomStream& random) {
  if (formula.parameters.empty()) return;
  const int k = random.below(static_cast<int>(formula.parameters.size()));
  const Parameter& p = formula.parameters[k];
  double& x = s.parameters[k];
  if (p.whole) {
    x = p.lowest + 1 + random.below(static_cast<int>(p.highest - p.lowest) - 1);
    return;
  }
  switch (random.below(5)) {
    case 0: x = p.preset; break;
    case 1: x = p.includes_infinity ? random_sign(random) * HUGE_VAL : p.highest; break;
    case 2: x = (std::isfinite(p.highest) ? p.highest : x) * (1 - std::pow(10.0, random.uniform(-16, 0))); break;
    case 3: x = (std::isfinite(p.lowest) ? p.lowest : x) * (1 - std::pow(10.0, random.uniform(-16, 0))); break;
    default: x *= 1 + random_step(random, -16, 1); break;
  }
}

constexpr std::array all_mutations{Mutation{"step by size", step_by_size},
                                   Mutation{"step by itself", step_by_itself},
                                   Mutation{"one ulp", one_ulp},
                                   Mutation{"snap coordinate", snap_coordinate},
                                   Mutation{"tiny coordinate", tiny_coordinate},
                                   Mutation{"round coordinate", round_coordinate},
                                   Mutation{"flatten", flatten},
                                   Mutation{"align", align},
                                   Mutation{"round all", round_all},
                                   Mutation{"along edge", along_edge},
                                   Mutation{"across edge", across_edge},
                                   Mutation{"off surface", off_surface},
                                   Mutation{"scale distance", scale_distance},
                                   Mutation{"onto feature", onto_feature},
                                   Mutation{"foot to origin", foot_to_origin},
                                   Mutation{"shift all", shift_all},
                                   Mutation{"scale all", scale_all},
                                   Mutation{"change aspect", change_aspect},
                                   Mutation{"turn over", turn_over},
                                   Mutation{"point anew", point_anew},
                                   Mutation{"change parameter", change_parameter}};

}  // namespace

std::span<const Mutation> mutations() { return all_mutations; }

void mutate(const Mutation& mutation, const Formula& formula, Sample& sample, RandomStream& random) {
  double largest = 0;
  for (const Vec& v : sample.corners) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  const bool extreme = largest > 0 && std::isfinite(largest) && (largest < 1e-100 || largest > 1e100);
  const int unit = extreme ? std::ilogb(largest) : 0;
  const auto scale = [&](int exponent) {
    for (Vec& v : sample.corners)
      for (double& x : v) x = std::ldexp(x, exponent);
    for (double& x : sample.point) x = std::ldexp(x, exponent);
  };
  if (extreme) scale(-unit);
  mutation.apply(formula, sample, random);
  if (extreme) scale(unit);
}

}  // namespace cageproof::validation
