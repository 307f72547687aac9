// SPDX-License-Identifier: MIT
#include "plane_shapes.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace cageproof::validation {
namespace {

using PlanePoints = std::vector<Vec3<double>>;

Vec3<double> inward(const Vec3<double>& from, const Vec3<double>& to) {
  const Vec3<double> along = (to - from).normalized();
  return {-along[1], along[0], 0};
}

// The polygon whose edges lie so far inside.
PlanePoints inset(const PlanePoints& polygon, double depth) {
  PlanePoints found;
  found.reserve(polygon.size());
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3<double> before = inward(polygon[(k + n - 1) % n], polygon[k]),
                       after = inward(polygon[k], polygon[(k + 1) % n]);
    found.emplace_back(polygon[k] + depth / (1 + before.dot(after)) * (before + after));
  }
  return found;
}

Vec3<double> turned(const Vec3<double>& p, double angle) {
  return {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1], 0};
}

}  // namespace

Cage polygon_of(std::string name, PlanePoints vertices) {
  const int count = static_cast<int>(vertices.size());
  std::vector<Face> segments;
  segments.reserve(vertices.size());
  for (int k = 0; k < count; ++k) segments.push_back({{k, (k + 1) % count, -1, -1}});
  return Cage::make_polygon(std::move(name), std::move(vertices), std::move(segments));
}

TonedMesh patched(const Cage& cage, const PlanePoints& inner, const std::vector<Patch>& patches) {
  PlanePoints corners = inset(cage.vertices(), 1e-6 * cage.size());
  corners.insert(corners.end(), inner.begin(), inner.end());
  TonedMesh found;
  // Vertices of an edge by its ends and their number from the lower one: both of its patches have them.
  std::map<std::tuple<int, int, int>, int> known;
  for (const Patch& patch : patches) {
    const auto& c = patch.corners;
    const auto new_vertex = [&](int i, int j) {
      const double u = static_cast<double>(i) / patch.across, v = static_cast<double>(j) / patch.up;
      found.mesh.vertices.emplace_back((1 - v) * ((1 - u) * corners[c[0]] + u * corners[c[1]]) +
                                       v * ((1 - u) * corners[c[3]] + u * corners[c[2]]));
      return static_cast<int>(found.mesh.vertices.size()) - 1;
    };
    // The number along an edge from one corner to another; a corner is an edge of its own.
    const auto key = [&](int from, int to, int at, int steps) {
      if (at == 0 || at == steps) {
        const int corner = c[at == 0 ? from : to];
        return std::tuple(corner, corner, 0);
      }
      return c[from] < c[to] ? std::tuple(c[from], c[to], at) : std::tuple(c[to], c[from], steps - at);
    };
    const auto vertex = [&](int i, int j) {
      const bool on_edge = i == 0 || j == 0 || i == patch.across || j == patch.up;
      if (!on_edge) return new_vertex(i, j);
      const auto at = j == 0              ? key(0, 1, i, patch.across)
                      : j == patch.up     ? key(3, 2, i, patch.across)
                      : i == patch.across ? key(1, 2, j, patch.up)
                                          : key(0, 3, j, patch.up);
      const auto place = known.find(at);
      return place != known.end() ? place->second : known[at] = new_vertex(i, j);
    };
    std::vector<std::vector<int>> rows(patch.up + 1);
    for (int j = 0; j <= patch.up; ++j)
      for (int i = 0; i <= patch.across; ++i) rows[j].push_back(vertex(i, j));
    for (int j = 0; j < patch.up; ++j)
      for (int i = 0; i < patch.across; ++i) {
        found.mesh.faces.push_back({rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]});
        found.tones.push_back(static_cast<char>((i / 2 + j / 2) % 2));
      }
  }
  return found;
}

PlanePoints beside_edges(const Cage& cage, double depth, int per_edge) {
  PlanePoints found;
  for (const Face& face : cage.faces()) {
    const Vec3<double>&from = cage.vertices()[face.vertices[0]], &to = cage.vertices()[face.vertices[1]];
    for (int k = 0; k < per_edge; ++k)
      found.emplace_back(from + (k + 0.5) / per_edge * (to - from) + depth * cage.size() * inward(from, to));
  }
  return found;
}

Cage plane_square() { return polygon_of("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}); }

TonedMesh square_mesh(const Cage& square, int cells) { return patched(square, {}, {{{0, 1, 2, 3}, cells, cells}}); }

Cage plane_star() {
  PlanePoints vertices;
  for (int k = 0; k < 10; ++k) {
    const double angle = std::numbers::pi * (0.5 + 0.2 * k);
    vertices.emplace_back(Vec3<double>(std::cos(angle), std::sin(angle), 0) * (k % 2 == 0 ? 2 : 1));
  }
  return polygon_of("star", std::move(vertices));
}

TonedMesh star_mesh(const Cage& star) {
  constexpr int cells = 8;
  std::vector<Patch> patches;
  for (int tip = 0; tip < 10; tip += 2) patches.push_back({{10, (tip + 9) % 10, tip, tip + 1}, cells, cells});
  return patched(star, {Vec3<double>::Zero()}, patches);
}

PlanePoints swirled_star(const Cage& star) {
  PlanePoints posed = star.vertices();
  for (std::size_t k = 0; k < posed.size(); k += 2) posed[k] = turned(posed[k], -0.45);
  posed[0] *= 1.35;
  return posed;
}

PlanePoints lifted_star(const Cage& star) {
  PlanePoints posed = star.vertices();
  posed[0] *= 1.25;
  posed[2] = turned(posed[2], -0.2);
  posed[8] = turned(posed[8], 0.2);
  return posed;
}

Cage plane_trousers() {
  return polygon_of("trousers", {{0, 0, 0},
                                 {1.7, 0, 0},
                                 {2, 3, 0},
                                 {2.3, 0, 0},
                                 {4, 0, 0},
                                 {3.64, 3, 0},
                                 {3.4, 5, 0},
                                 {2, 5, 0},
                                 {0.6, 5, 0},
                                 {0.36, 3, 0}});
}

TonedMesh trousers_mesh(const Cage& trousers) {
  constexpr int across = 8, leg = 14, above = 10;
  return patched(trousers, {},
                 {{{0, 1, 2, 9}, across, leg},
                  {{3, 4, 5, 2}, across, leg},
                  {{9, 2, 7, 8}, across, above},
                  {{2, 5, 6, 7}, across, above}});
}

PlanePoints lifted_leg(const Cage& trousers) {
  PlanePoints posed = trousers.vertices();
  posed[3] = {4.1, 0.55, 0};
  posed[4] = {5.5, 1.4, 0};
  return posed;
}

Cage plane_animal() {
  return polygon_of(
      "animal", {{0, 0, 0},     {0.6, 0, 0},   {0.6, 1.6, 0}, {2.4, 1.6, 0}, {2.4, 0, 0},   {3, 0, 0},   {3, 1.6, 0},
                 {3, 2.8, 0},   {3, 4.1, 0},   {3, 5.4, 0},   {4.2, 5.4, 0}, {4.2, 6.2, 0}, {3, 6.2, 0}, {2.4, 6.2, 0},
                 {2.4, 5.4, 0}, {2.4, 4.1, 0}, {2.4, 2.8, 0}, {0.6, 2.8, 0}, {0, 2.8, 0},   {0, 1.6, 0}});
}

TonedMesh animal_mesh(const Cage& animal) {
  constexpr int thin = 4, leg = 10, body = 8, middle = 12, neck = 8, head = 6, muzzle = 8;
  return patched(animal, {},
                 {{{0, 1, 2, 19}, thin, leg},
                  {{19, 2, 17, 18}, thin, body},
                  {{2, 3, 16, 17}, middle, body},
                  {{4, 5, 6, 3}, thin, leg},
                  {{3, 6, 7, 16}, thin, body},
                  {{16, 7, 8, 15}, thin, neck},
                  {{15, 8, 9, 14}, thin, neck},
                  {{14, 9, 12, 13}, thin, head},
                  {{9, 10, 11, 12}, muzzle, head}});
}

}  // namespace cageproof::validation
