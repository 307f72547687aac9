// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/embedded_cages.h"

#include "cageproof/core/input_error.h"
#include "embedded_polygons.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace cageproof {
namespace {

constexpr double kPi = std::numbers::pi;

struct Surface {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;

  int count() const { return static_cast<int>(vertices.size()); }
  void add(int a, int b, int c, int d = -1) { faces.push_back({{a, b, c, d}}); }
  /// Quads between two rings of n vertices; both run counter-clockwise seen from above.
  void join(int ring, int next_ring, int n) {
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      add(ring + i, ring + j, next_ring + j, next_ring + i);
    }
  }
  /// Four vertices (+-half, +-half, z), counter-clockwise seen from above, turned by `angle` about the z axis.
  int add_square(double half, double z, double angle = 0) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
      vertices.emplace_back(c * x - s * y, s * x + c * y, z);
    return count() - 4;
  }
};

constexpr int kBoxFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

Surface box_corners() {
  Surface s;
  for (int i = 0; i < 8; ++i) s.vertices.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
  return s;
}

Surface cube() {
  Surface s = box_corners();
  for (const auto& f : kBoxFaces) s.add(f[0], f[1], f[2], f[3]);
  return s;
}

Surface icosahedron() {
  Surface s;
  const double z = 1 / std::sqrt(5.0);
  s.vertices.emplace_back(0, 0, 1);
  for (int ring = 0; ring < 2; ++ring)
    for (int k = 0; k < 5; ++k) {
      const double angle = (2 * k + ring) * kPi / 5;
      s.vertices.emplace_back(2 * z * std::cos(angle), 2 * z * std::sin(angle), ring == 0 ? z : -z);
    }
  s.vertices.emplace_back(0, 0, -1);
  for (int k = 0; k < 5; ++k) {
    const int upper = 1 + k, upper_next = 1 + (k + 1) % 5, lower = 6 + k, lower_next = 6 + (k + 1) % 5;
    s.add(0, upper, upper_next);
    s.add(upper, lower, upper_next);
    s.add(upper_next, lower, lower_next);
    s.add(11, lower_next, lower);
  }
  return s;
}

// Each triangle in four, the new vertices on the unit sphere.
Surface icosphere() {
  Surface coarse = icosahedron(), s;
  s.vertices = coarse.vertices;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), s.count());
    if (is_new) s.vertices.push_back((s.vertices[a] + s.vertices[b]).normalized());
    return place->second;
  };
  for (const Face& face : coarse.faces) {
    const auto [a, b, c, none] = face.vertices;
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    s.add(a, ab, ca);
    s.add(b, bc, ab);
    s.add(c, ca, bc);
    s.add(ab, bc, ca);
  }
  return s;
}

Surface torus() {
  constexpr int around = 8, across = 6;
  Surface s;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double theta = 2 * kPi * i / around, phi = 2 * kPi * j / across;
      const double radius = 1 + 0.4 * std::cos(phi);
      s.vertices.emplace_back(radius * std::cos(theta), radius * std::sin(theta), 0.4 * std::sin(phi));
    }
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const auto at = [](int p, int q) { return p % around * across + q % across; };
      s.add(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return s;
}

Surface l_block() {
  Surface s;
  for (const double z : {-0.5, 0.5})
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}, {-1.0, 1.0}})
      s.vertices.emplace_back(x, y, z);
  s.join(0, 6, 6);
  s.add(0, 3, 2, 1);
  s.add(0, 5, 4, 3);
  for (int k = 1; k < 5; ++k) s.add(6 + 0, 6 + k, 6 + k + 1);
  return s;
}

Surface twisted_bar() {
  constexpr int segments = 4;
  Surface s;
  for (int i = 0; i <= segments; ++i) s.add_square(0.5, -1 + 2.0 * i / segments, i * kPi / (2 * segments));
  for (int i = 0; i < segments; ++i) s.join(4 * i, 4 * (i + 1), 4);
  s.add(0, 3, 2, 1);
  s.add(4 * segments, 4 * segments + 1, 4 * segments + 2, 4 * segments + 3);
  return s;
}

// A box open at the top, with walls and a floor of that thickness.
Surface open_box(double wall) {
  Surface s;
  const int outer_floor = s.add_square(1, -0.5), outer_rim = s.add_square(1, 0.5);
  const int inner_rim = s.add_square(1 - wall, 0.5), inner_floor = s.add_square(1 - wall, -0.5 + wall);
  s.add(outer_floor, outer_floor + 3, outer_floor + 2, outer_floor + 1);
  s.join(outer_floor, outer_rim, 4);
  s.join(outer_rim, inner_rim, 4);
  s.join(inner_rim, inner_floor, 4);
  s.add(inner_floor, inner_floor + 1, inner_floor + 2, inner_floor + 3);
  return s;
}

Surface thin_box() { return open_box(1.0 / 64); }

// A cube with a pyramid, higher than it is wide, on the middle of every face.
Surface spiky_box() {
  Surface s = box_corners();
  for (const auto& f : kBoxFaces) {
    const Vec3<double> centre = (s.vertices[f[0]] + s.vertices[f[2]]) / 2;
    const int base = s.count();
    for (const int corner : f) s.vertices.push_back((centre + s.vertices[corner]) / 2);
    s.vertices.push_back(centre * 2.5);
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      s.add(f[i], f[j], base + j, base + i);
      s.add(base + i, base + j, base + 4);
    }
  }
  return s;
}

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

// Both caps' faces, by corners of the outline.
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
    s.vertices.emplace_back(std::cos(2 * kPi * k / spokes), std::sin(2 * kPi * k / spokes), 0);
  for (const double z : {1.0, -0.25}) s.vertices.emplace_back(0.125, 0, z);
  for (int k = 0; k < spokes; ++k) {
    const int next = (k + 1) % spokes;
    s.add(k, next, spokes);
    s.add(next, k, spokes + 1);
  }
  return s;
}

struct Row {
  std::string_view name;
  Surface (*make)();
};

constexpr std::array kRows{Row{"cube", cube},          Row{"icosphere", icosphere},     Row{"torus", torus},
                           Row{"l-block", l_block},    Row{"twisted-bar", twisted_bar}, Row{"thin-box", thin_box},
                           Row{"spiky-box", spiky_box}};

// Cages with a thickness, opening or width that goes to zero by decades: 1e-<first>, then every `step`-th up to
// 1e-<last>.
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
                               Family{"fan", fan}};

struct Extreme {
  std::string name;
  const Family* family;
  double parameter;
};

const std::vector<Extreme>& extremes() {
  static const std::vector<Extreme> all = [] {
    std::vector<Extreme> found;
    for (const Family& family : kFamilies)
      for (int decade = family.first; decade <= family.last; decade += family.step)
        found.push_back({family.first == 0 ? std::string(family.name) : fmt::format("{}-1e-{}", family.name, decade),
                         &family, std::pow(10.0, -decade)});
    return found;
  }();
  return all;
}

}  // namespace

std::vector<std::string_view> extreme_cage_names() {
  std::vector<std::string_view> names;
  for (const Extreme& extreme : extremes()) names.push_back(extreme.name);
  return names;
}

bool is_embedded_cage(std::string_view name) {
  return std::ranges::find(kRows, name, &Row::name) != kRows.end() ||
         std::ranges::find(embedded_polygons(), name, &EmbeddedPolygon::name) != embedded_polygons().end() ||
         std::ranges::find(extremes(), name, &Extreme::name) != extremes().end();
}

std::vector<std::string_view> embedded_cage_names() {
  std::vector<std::string_view> names;
  for (const Row& row : kRows) names.push_back(row.name);
  for (const EmbeddedPolygon& polygon : embedded_polygons()) names.push_back(polygon.name);
  return names;
}

Cage embedded_cage(std::string_view name) {
  for (const Row& row : kRows)
    if (row.name == name) {
      Surface surface = row.make();
      return Cage::make(std::string(name), std::move(surface.vertices), std::move(surface.faces));
    }
  for (const EmbeddedPolygon& polygon : embedded_polygons())
    if (polygon.name == name) return polygon.make();
  for (const Extreme& extreme : extremes())
    if (extreme.name == name) {
      Surface surface = extreme.family->make(extreme.parameter);
      return Cage::make(std::string(name), std::move(surface.vertices), std::move(surface.faces));
    }
  throw InputError(fmt::format("no embedded cage is called \"{}\"; there are {}, {}", name,
                               fmt::join(embedded_cage_names(), ", "), fmt::join(extreme_cage_names(), ", ")));
}

}  // namespace cageproof
