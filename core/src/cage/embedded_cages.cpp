// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/embedded_cages.h"

#include "cageproof/core/input_error.h"
#include "embedded_polygons.h"
#include "extreme_cages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace cageproof {
namespace {

constexpr double kPi = std::numbers::pi;

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

struct Row {
  std::string_view name;
  Surface (*make)();
};

constexpr std::array kRows{Row{"cube", cube},          Row{"icosphere", icosphere},     Row{"torus", torus},
                           Row{"l-block", l_block},    Row{"twisted-bar", twisted_bar}, Row{"thin-box", thin_box},
                           Row{"spiky-box", spiky_box}};

}  // namespace

std::vector<std::string_view> extreme_cage_names() {
  std::vector<std::string_view> names;
  for (const ExtremeCage& extreme : extreme_cages()) names.push_back(extreme.name);
  return names;
}

bool is_embedded_cage(std::string_view name) {
  return std::ranges::find(kRows, name, &Row::name) != kRows.end() ||
         std::ranges::find(embedded_polygons(), name, &EmbeddedPolygon::name) != embedded_polygons().end() ||
         std::ranges::find(extreme_cages(), name, &ExtremeCage::name) != extreme_cages().end();
}

std::vector<std::string_view> embedded_cage_names() {
  std::vector<std::string_view> names;
  names.reserve(kRows.size() + embedded_polygons().size());
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
  for (const ExtremeCage& extreme : extreme_cages())
    if (extreme.name == name) {
      Surface surface = extreme.make();
      return Cage::make(std::string(name), std::move(surface.vertices), std::move(surface.faces));
    }
  throw InputError(fmt::format("no embedded cage is called \"{}\"; there are {}, {}", name,
                               fmt::join(embedded_cage_names(), ", "), fmt::join(extreme_cage_names(), ", ")));
}

}  // namespace cageproof
