// SPDX-License-Identifier: MIT
// Samples of segments and points, one regime after another.
#pragma once

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/random_stream.h"

#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cageproof::closed_form::segment {

struct SegmentSample {
  Segment<double> s;
  Vec3<double> point;
};

/// A point in the frame of a random segment of length near one: `along` from its first end, `across` to its left. Where
/// the nearest end, or the nearest point of the line, is to be at the origin (`origin` in [0, 1], the hat function of
/// the last end), doubles hold distances of any size exactly.
inline SegmentSample placed(RandomStream& random, double along, double across, double origin, bool at_origin) {
  const double turn = random.uniform(0, 2 * std::numbers::pi), length = random.uniform(0.5, 2);
  const Vec3<double> e(length * std::cos(turn), length * std::sin(turn), 0), left(-std::sin(turn), std::cos(turn), 0);
  const Vec3<double> base =
      at_origin ? Vec3<double>(-origin * e) : Vec3<double>(random.uniform(-1, 1), random.uniform(-1, 1), 0);
  const Vec3<double> step = (along - (at_origin ? origin : 0)) * e + across * left;
  return {{base, Vec3<double>(base + e)}, at_origin ? step : Vec3<double>(base + step)};
}

/// The regimes' names, and what makes their samples.
inline std::vector<std::pair<std::string, std::function<SegmentSample(int)>>> segment_regimes() {
  const auto stream = [](const char* name, int i) { return RandomStream(77, name, i); };
  const auto distance = [](int i) { return std::pow(10.0, -1 - i % 16); };
  return {
      {"generic",
       [=](int i) {
         auto r = stream("generic", i);
         return placed(r, r.uniform(-1, 2), r.uniform(-1, 1), 0, false);
       }},
      {"near-face",
       [=](int i) {
         auto r = stream("near-face", i);
         const double x = r.uniform(0.05, 0.95);
         return placed(r, x, (i & 1 ? -1 : 1) * distance(i / 2), x, i % 4 < 2);
       }},
      {"near-line",
       [=](int i) {
         auto r = stream("near-line", i);
         const double x = r.uniform(0.1, 1);
         return placed(r, i % 3 ? 1 + x : -x, (i & 1 ? -1 : 1) * distance(i / 2), i % 3 ? 1 : 0, i % 4 < 2);
       }},
      {"near-vertex",
       [=](int i) {
         auto r = stream("near-vertex", i);
         const double w = r.uniform(0, 2 * std::numbers::pi), d = distance(i);
         return placed(r, (i & 1) + d * std::cos(w), d * std::sin(w), i & 1, i % 4 < 2 || d < 1e-14);
       }},
      {"far",
       [=](int i) {
         auto r = stream("far", i);
         const double w = r.uniform(0, 2 * std::numbers::pi), d = std::pow(10.0, i % 9);
         return placed(r, d * std::cos(w), d * std::sin(w), 0, i % 2 == 0);
       }},
      {"switch",
       [=](int i) {
         auto r = stream("switch", i);
         const double w = r.uniform(0, 2 * std::numbers::pi), d = r.uniform(0.7, 3);
         return placed(r, d * std::cos(w), d * std::sin(w), 0, false);
       }},
      {"scaled",
       [=](int i) {
         auto r = stream("scaled", i);
         SegmentSample x = placed(r, r.uniform(-1, 2), r.uniform(-1, 1), 0, false);
         const double unit = std::pow(10.0, -100 + 20 * (i % 11));
         x.s[0] *= unit;
         x.s[1] *= unit;
         x.point *= unit;
         return x;
       }},
      {"offset",
       [=](int i) {
         auto r = stream("offset", i);
         SegmentSample x = placed(r, r.uniform(-1, 2), r.uniform(-1, 1), 0, false);
         const Vec3<double> by = std::pow(10.0, 1 + i % 8) * Vec3<double>(0.6, -0.8, 0);
         x.s[0] += by;
         x.s[1] += by;
         x.point += by;
         return x;
       }},
  };
}

}  // namespace cageproof::closed_form::segment
