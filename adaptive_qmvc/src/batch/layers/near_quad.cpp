// SPDX-License-Identifier: MIT
#include "near_quad.h"

#include "../chunk_size.h"

#include "quad/engine/singular_pairs.h"
#include "cageproof/core/numbers/gauss_legendre.h"

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::batch {
namespace {

// The most lines of a strip: about the number for which a digit takes the fewest lines, if strips grow by one factor.
constexpr int kMostInStrip = 20;
constexpr int kMostCuts = 64;
// In sizes of the quad: nearer than the first one the element's own evaluation is asked, and where sides are of unequal
// lengths nearer than the second. Points within the third may be on the quad.
constexpr double kSeen = 0x1p-36, kSeenUneven = 0x1p-8, kMayTouch = 1e-11;

struct Place {
  double u, v, distance2;
};

Place place_at(const QuadFrame<double>& q, double u, double v) {
  const Vec3<double> x = q.start(v) + u * q.direction(v);
  return {u, v, x.dot(x)};
}

// With the nearest u of line v.
Place place_on_line(const QuadFrame<double>& q, double v) {
  const Vec3<double> a = q.start(v), e = q.direction(v);
  const double square = e.dot(e);
  return place_at(q, square > 0 ? std::clamp(-a.dot(e) / square, 0., 1.) : 0., v);
}

// A point of the quad that is about as near as any: the best of some lines, and Gauss-Newton steps as long as they
// help. Strips are right for any, and only longer than they need be about a worse one.
Place near_place(const QuadFrame<double>& q) {
  Place best = place_on_line(q, 0);
  for (const double v : {0.25, 0.5, 0.75, 1.}) {
    const Place other = place_on_line(q, v);
    if (other.distance2 < best.distance2) best = other;
  }
  for (int round = 0; round < 8; ++round) {
    const Vec3<double> e = q.along(best.v), b = q.across(best.u), x = q.start(best.v) + best.u * q.direction(best.v);
    const double ee = e.dot(e), eb = e.dot(b), bb = b.dot(b), det = ee * bb - eb * eb;
    if (!(det > 0)) return best;
    const double v = std::clamp(best.v - (ee * x.dot(b) - eb * x.dot(e)) / det, 0., 1.);
    const Place other = place_on_line(q, v);
    if (!(other.distance2 < best.distance2)) return best;
    const bool settled = other.distance2 > 0.9 * best.distance2;
    best = other;
    if (settled) return best;
  }
  return best;
}

void put_space(double (&to)[3], const Vec3<double>& from) { std::copy_n(from.data(), 3, to); }

NearQuad near_quad(const LocalFrame<double>& q) {
  const LineArea<double> area(q.a, q.e, q.w, q.n, q.n_v);
  NearQuad near{};
  near.u0 = q.u0, near.v0 = q.v0;
  near.g00 = q.g00, near.g01 = q.g01, near.g10 = q.g10, near.g11 = q.g11;
  put_space(near.a, q.a), put_space(near.e, q.e), put_space(near.b, q.b), put_space(near.w, q.w);
  put_space(near.c0, area.c0), put_space(near.c1, area.c1), put_space(near.c2, area.c2);
  return near;
}

// From the line at a step.
double distance_of_line(const LocalFrame<double>& q, double step) {
  const Vec3<double> e = q.direction(step);
  return distance_of_segment<double>(q.start(step) + q.first * e, e);
}

}  // namespace

// Between two lines, at steps from the frame's, and their distances.
struct NearQuadLayers::Strip {
  double lo, hi, from_lo, from_hi;
};

void NearQuadLayers::add_lines(const Strip& strip, int lines) {
  const GaussLegendre<double>& gauss = gauss_legendre<double>(lines);
  const double range = strip.hi - strip.lo;
  for (int i = 0; i < lines; ++i) {
    step_.push_back(strip.lo + range * gauss.nodes[i]);
    weight_.push_back(range * gauss.weights[i]);
  }
}

// \param longest of the sides across the lines \param distance of the frame's own point. False where a strip needs more
// lines however often it is cut.
bool NearQuadLayers::cut(const LocalFrame<double>& local, double longest, double distance, const Strip& strip,
                         int depth) {
  const int lines = plans_.lines_for((strip.from_lo + strip.from_hi) / (longest * (strip.hi - strip.lo)));
  if (lines > 0 && lines <= kMostInStrip) {
    add_lines(strip, lines);
    return true;
  }
  if (depth == kMostCuts) return false;
  double middle = 0;
  if (strip.lo >= 0 || strip.hi <= 0) {
    // So that both parts are seen under about the same angle.
    const double sign = strip.lo >= 0 ? 1 : -1, high = distance / longest;
    middle = sign * (std::sqrt((std::abs(strip.lo) + high) * (std::abs(strip.hi) + high)) - high);
  }
  if (!(middle > strip.lo && middle < strip.hi)) return false;
  const double from_middle = distance_of_line(local, middle);
  return cut(local, longest, distance, {strip.lo, middle, strip.from_lo, from_middle}, depth + 1) &&
         cut(local, longest, distance, {middle, strip.hi, from_middle, strip.from_hi}, depth + 1);
}

NearQuadLayers::Reach NearQuadLayers::add(std::span<const Vec3<double>> corners, const Vec3<double>& point,
                                          QuadLayers& layers) {
  const auto q = quad_frame<double>(corners, point);
  if (!q) return Reach::Touching;
  const Place place = near_place(*q);
  const double distance = std::sqrt(place.distance2);
  const double along = std::sqrt(std::max(q->e.dot(q->e), q->e1.dot(q->e1)));
  if (!(distance > kMayTouch * along)) return Reach::Touching;
  if (distance < (is_uneven(*q) ? kSeenUneven : kSeen) * along || is_folded(*q)) return Reach::Nearer;
  const LocalFrame<double> local(*q, place.u, place.v, seen_at<double>(*q, corners, point, place.u, place.v));
  step_.clear();
  weight_.clear();
  const double longest = std::sqrt(std::max(q->b.dot(q->b), q->b1.dot(q->b1))), lo = -place.v, hi = 1 - place.v;
  if (!cut(local, longest, distance, {lo, hi, distance_of_line(local, lo), distance_of_line(local, hi)}, 0))
    return Reach::Nearer;
  // A vector that is not full goes on with its last line, whose weight is none.
  while (step_.size() % kWidest != 0) {
    step_.push_back(step_.back());
    weight_.push_back(0);
  }
  double sums[16] = {};
  const NearQuad near = near_quad(local);
  kernels_.add_near_layers({&near, static_cast<int>(step_.size()), step_.data(), weight_.data(), biharmonic_}, sums);
  for (int k = 0; k < 4; ++k) {
    const int corner = q->unit.corner[k];
    const int unit = q->unit.exponent;
    layers.of[0][corner] += q->unit.sign * sums[k];
    layers.of[1][corner] += std::ldexp(sums[4 + k], -unit);
    layers.of[2][corner] += q->unit.sign * std::ldexp(sums[8 + k], 2 * unit);
    layers.of[3][corner] += std::ldexp(sums[12 + k], unit);
  }
  return Reach::Lines;
}

}  // namespace cageproof::adaptive_qmvc::batch
