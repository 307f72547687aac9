// SPDX-License-Identifier: MIT
#include "embedded_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof {
namespace {

using Loop = EmbeddedPolygon::Loop;
using Loops = std::vector<Loop>;
using Point = Vec3<double>;

Loop rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}};
}

Loops square() { return {rectangle(0, 0, 1, 1)}; }

Loops l_shape() { return {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}}; }

// Five points near the unit circle, in units of 2^-10: so that points along the edges are exact, and limits there have
// samples.
Loops star() {
  constexpr int points = 5;
  Loop loop;
  for (int k = 0; k < 2 * points; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.375, angle = std::numbers::pi * (0.5 + k / static_cast<double>(points));
    const auto rounded = [](double x) { return std::round(1024 * x) / 1024; };
    loop.emplace_back(rounded(radius * std::cos(angle)), rounded(radius * std::sin(angle)), 0);
  }
  return {loop};
}

// Five teeth, as wide as the gaps between them.
Loops comb() {
  constexpr int teeth = 5;
  constexpr double width = 0.125, spine = 0.25, height = 1.25;
  Loop loop{{0, 0, 0}, {(2 * teeth - 1) * width, 0, 0}};
  for (int k = teeth - 1; k >= 0; --k) {
    const double left = 2 * k * width, right = left + width;
    if (k < teeth - 1) loop.emplace_back(right, spine, 0);
    loop.emplace_back(right, height, 0);
    loop.emplace_back(left, height, 0);
    if (k > 0) loop.emplace_back(left, spine, 0);
  }
  return {loop};
}

Loops thin_bar() { return {rectangle(-1, 0, 1, 1.0 / 64)}; }

// A square with a square hole.
Loops frame() {
  Loop hole = rectangle(-0.5, -0.5, 0.5, 0.5);
  return {rectangle(-1, -1, 1, 1), {hole.rbegin(), hole.rend()}};
}

// A joint of a limb, and half of how wide the limb is there.
struct Joint {
  double x, y, half_width;

  Point at() const { return {x, y, 0}; }
};

// Walks around a limb with it on the left: out along its bones, around its tip and back, each bone's side in three
// edges.
void add_limb(Loop& loop, std::span<const Joint> joints) {
  constexpr int pieces = 3;
  const std::size_t last = joints.size() - 1;
  const auto along = [&](std::size_t bone) { return (joints[bone + 1].at() - joints[bone].at()).normalized(); };
  // Right of a joint, halfway between what is right of the bones before and after it.
  const auto beside = [&](std::size_t j) {
    const Point both = (j > 0 ? along(j - 1) : along(j)) + (j < last ? along(j) : along(j - 1));
    return Point(joints[j].half_width * Point(both[1], -both[0], 0).normalized());
  };
  const auto add_side = [&](double side, bool outward) {
    for (std::size_t k = 0; k <= pieces * last; ++k) {
      const std::size_t step = outward ? k : pieces * last - k, bone = std::min(step / pieces, last - 1);
      const double share = static_cast<double>(step - pieces * bone) / pieces;
      const Point from = joints[bone].at() + side * beside(bone), to = joints[bone + 1].at() + side * beside(bone + 1);
      loop.emplace_back((1 - share) * from + share * to);
    }
  };
  add_side(1, true);
  loop.push_back(joints[last].at() + joints[last].half_width * along(last - 1));
  add_side(-1, false);
}

// Someone who waves: 100 edges.
Loops figure() {
  using Limb = std::vector<Joint>;
  const Limb right_leg{{0.16, -0.04, 0.13}, {0.3, -0.48, 0.09}, {0.22, -0.95, 0.05}, {0.42, -1.03, 0.04}};
  const Limb right_arm{{0.24, 0.6, 0.08}, {0.55, 0.42, 0.06}, {0.6, 0.8, 0.045}, {0.65, 0.95, 0.05}};
  const Limb head{{0, 0.74, 0.08}, {0.02, 0.97, 0.15}, {0.03, 1.14, 0.08}};
  const Limb left_arm{{-0.24, 0.6, 0.08}, {-0.45, 0.26, 0.06}, {-0.72, 0.1, 0.045}, {-0.86, 0.04, 0.05}};
  const Limb left_leg{{-0.16, -0.04, 0.13}, {-0.2, -0.5, 0.09}, {-0.34, -0.93, 0.05}, {-0.54, -1, 0.04}};
  Loop loop{{0, -0.1, 0}};
  for (const Limb& limb : {right_leg, right_arm, head, left_arm, left_leg}) add_limb(loop, limb);
  return {loop};
}

constexpr EmbeddedPolygon kPolygons[]{{"square", square},     {"l-shape", l_shape}, {"star", star},    {"comb", comb},
                                      {"thin-bar", thin_bar}, {"frame", frame},     {"figure", figure}};

}  // namespace

Cage EmbeddedPolygon::make() const {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> segments;
  for (const Loop& loop : loops()) {
    const int first = static_cast<int>(vertices.size()), count = static_cast<int>(loop.size());
    for (int k = 0; k < count; ++k) segments.push_back({{first + k, first + (k + 1) % count, -1, -1}});
    vertices.insert(vertices.end(), loop.begin(), loop.end());
  }
  return Cage::make_polygon(std::string(name), std::move(vertices), std::move(segments));
}

std::span<const EmbeddedPolygon> embedded_polygons() { return kPolygons; }

}  // namespace cageproof
