// SPDX-License-Identifier: MIT
#include "extreme_cages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

// A prism over a polygon of n points of the plane y = 0, which are the first n vertices, counter-clockwise seen from
// -y; its caps are to be added.
Surface prism(const std::vector<std::pair<double, double>>& outline) {
  Surface s;
  for (const double y : {-0.5, 0.5})
    for (const auto& [x, z] : outline) s.vertices.emplace_back(x, y, z);
  const int n = static_cast<int>(outline.size());
  // Seen from -y the outline turns to the left, so the second ring lies on its right.
  for (int i = 0; i < n; ++i) s.add(i, n + i, n + (i + 1) % n, (i + 1) % n);
  return s;
}

// Adds the faces of both caps. `faces` has corners of the outline.
void add_caps(Surface& s, const std::vector<std::vector<int>>& faces) {
  const int n = s.count() / 2;
  for (const auto& f : faces) {
    if (f.size() == 3) {
      s.add(f[0], f[1], f[2]);
      s.add(n + f[0], n + f[2], n + f[1]);
    } else {
      s.add(f[0], f[1], f[2], f[3]);
      s.add(n + f[0], n + f[3], n + f[2], n + f[1]);
    }
  }
}

// A wedge: two unit squares that meet in an edge, and are `opening` apart at their other ends.
Surface wedge(double opening) {
  Surface s = prism({{0, 0}, {1, 0}, {1, opening}});
  add_caps(s, {{0, 1, 2}});
  return s;
}

// A cube cut from its top to its middle by a crack of that width.
Surface crack(double width) {
  const double w = width / 2;
  Surface s = prism({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {w, 0.5}, {w, 0}, {-w, 0}, {-w, 0.5}, {-0.5, 0.5}});
  add_caps(s, {{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}});
  return s;
}

// Adds another surface, scaled and moved, and turned inside out where it bounds a cavity.
void append(Surface& s, const Surface& other, double unit, const Vec3<double>& at, bool cavity) {
  const int first = s.count();
  for (const auto& v : other.vertices) s.vertices.push_back(unit * v + at);
  for (const Face& face : other.faces) {
    Face& added = s.faces.emplace_back(face);
    for (int k = 0; k < added.size(); ++k) added.vertices[k] += first;
    if (cavity) std::reverse(added.vertices.begin() + 1, added.vertices.begin() + added.size());
  }
}

// A cube around a cavity, with a wall of that thickness.
Surface hollow(double wall) {
  Surface s;
  append(s, cube(), 1, {0, 0, 0}, false);
  append(s, cube(), 1 - 2 * wall, {0, 0, 0}, true);
  return s;
}

// Two cubes side by side, that far from each other.
Surface gap(double width) {
  Surface s;
  append(s, cube(), 1, {-0.5, 0, 0}, false);
  append(s, cube(), 1, {0.5 + width, 0, 0}, false);
  return s;
}

// Shells and cavities in turn, three deep, and a small part beside them.
Surface nested(double) {
  Surface s;
  append(s, cube(), 1, {0, 0, 0}, false);
  append(s, cube(), 0.75, {0.0625, 0, 0}, true);
  append(s, icosahedron(), 0.25, {0, 0, 0.03125}, false);
  append(s, cube(), 0.125, {0.75, 0.25, 0.25}, false);
  return s;
}

// A double pyramid over a polygon of 64 corners, which both its tips are joined to.
Surface fan(double) {
  constexpr int spokes = 64;
  Surface s;
  for (int k = 0; k < spokes; ++k)
    s.vertices.emplace_back(std::cos(2 * std::numbers::pi * k / spokes), std::sin(2 * std::numbers::pi * k / spokes),
                            0);
  for (const double z : {1.0, -0.25}) s.vertices.emplace_back(0.125, 0, z);
  for (int k = 0; k < spokes; ++k) {
    const int next = (k + 1) % spokes;
    s.add(k, next, spokes);
    s.add(next, k, spokes + 1);
  }
  return s;
}

// A tetrahedron with a corner cut off, by a triangle of that width.
Surface bevel(double width) {
  Surface s;
  for (const double size : {1.0, width})
    for (int axis = 0; axis < 3; ++axis) s.vertices.push_back(size * Vec3<double>::Unit(axis));
  s.add(0, 1, 2);
  s.add(3, 5, 4);
  for (int k = 0; k < 3; ++k) s.add(3 + k, 3 + (k + 1) % 3, (k + 1) % 3, k);
  return s;
}

// A cube with a pyramid of that width and height on its top.
Surface bump(double width) {
  Surface s = cube();
  const auto top = s.faces[1].vertices;
  s.faces.erase(s.faces.begin() + 1);
  const Vec3<double> centre(0, 0, 0.5);
  const int base = s.count(), tip = base + 4;
  for (const int corner : top) s.vertices.push_back(centre + width * (s.vertices[corner] - centre));
  s.vertices.emplace_back(0, 0, 0.5 + width);
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    s.add(top[i], top[j], base + j, base + i);
    s.add(base + i, base + j, tip);
  }
  return s;
}

// An hourglass with a waist of that width.
Surface pinch(double width) {
  Surface s;
  const int low = s.add_square(0.5, -0.5), waist = s.add_square(width / 2, 0), high = s.add_square(0.5, 0.5);
  s.add(low, low + 3, low + 2, low + 1);
  s.join(low, waist, 4);
  s.join(waist, high, 4);
  s.add(high, high + 1, high + 2, high + 3);
  return s;
}

// A box whose top rises to a tip by rings of faces, each a tenth of the one before, down to 1e-8.
Surface graded(double) {
  constexpr int rings = 9;
  Surface s;
  int ring = s.add_square(1, -1);
  s.add(ring, ring + 3, ring + 2, ring + 1);
  for (int k = 0; k < rings; ++k) {
    const double half = std::pow(10.0, -k);
    const int next = s.add_square(half, -half / 2);
    s.join(ring, next, 4);
    ring = next;
  }
  s.vertices.emplace_back(0, 0, 0);
  for (int i = 0; i < 4; ++i) s.add(ring + i, ring + (i + 1) % 4, s.count() - 1);
  return s;
}

// A double pyramid over a polygon with a corner rounded at that radius, which makes needles of the triangles there.
Surface needles(double radius) {
  constexpr int steps = 6;
  Surface s;
  s.vertices.emplace_back(-1, 1, 0);
  s.vertices.emplace_back(-1, -1, 0);
  for (int k = 0; k <= steps; ++k) {
    const double angle = std::numbers::pi * (static_cast<double>(k) / steps - 0.5);
    s.vertices.emplace_back(1 + radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  const int corners = s.count();
  for (const double z : {0.5, -0.5}) s.vertices.emplace_back(-0.25, 0.125, z);
  for (int k = 0; k < corners; ++k) {
    const int next = (k + 1) % corners;
    s.add(k, next, corners);
    s.add(next, k, corners + 1);
  }
  return s;
}

// Cages with a length that goes to zero by decades: 1e-<first>, then every `step`-th up to 1e-<last>.
struct Family {
  std::string_view name;
  Surface (*make)(double parameter);
  int first = 0, last = 0, step = 1;  // 0: no parameter
};

constexpr std::array kFamilies{Family{"thin-wall", open_box, 1, 12},
                               Family{"wedge", wedge, 2, 12, 2},
                               Family{"crack", crack, 2, 12, 2},
                               Family{"hollow", hollow, 3, 12, 3},
                               Family{"gap", gap, 3, 12, 3},
                               Family{"nested", nested},
                               Family{"fan", fan},
                               Family{"bevel", bevel, 2, 8, 3},
                               Family{"bump", bump, 2, 8, 3},
                               Family{"pinch", pinch, 2, 8, 3},
                               Family{"needles", needles, 2, 8, 3},
                               Family{"graded", graded}};

}  // namespace

const std::vector<ExtremeCage>& extreme_cages() {
  static const std::vector<ExtremeCage> all = [] {
    std::vector<ExtremeCage> found;
    for (const Family& family : kFamilies)
      for (int decade = family.first; decade <= family.last; decade += family.step)
        found.push_back({family.first == 0 ? std::string(family.name) : fmt::format("{}-1e-{}", family.name, decade),
                         family.make, std::pow(10.0, -decade)});
    return found;
  }();
  return all;
}

}  // namespace cageproof
