// SPDX-License-Identifier: MIT
// Cages of quads that are kept, with poses and points: planar and twisted quads, integer corners, quads among
// triangles.
#pragma once

#include "support.h"

#include "cageproof/core/numbers/random_stream.h"

namespace cageproof::deformation::test {

/// Each vertex moved by itself, up to that part of the cage's size.
inline std::vector<Vec> shaken(const Cage& cage, double part) {
  std::vector<Vec> posed = cage.vertices();
  for (std::size_t v = 0; v < posed.size(); ++v) {
    RandomStream random(3, cage.name(), v);
    for (int c = 0; c < 3; ++c) posed[v][c] += part * cage.size() * random.uniform(-1, 1);
  }
  return posed;
}

inline Case shaken_case(const Cage& cage, std::vector<Vec> points) {
  const double size = cage.size();
  std::vector<Vec> posed = shaken(cage, 0.06);
  return {cage.name(), cage, std::move(posed), std::move(points), size};
}

/// The embedded cube with corners on the integers, 0 and 4.
inline Case integer_cube() {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec> vertices;
  for (const Vec& v : cube.vertices()) vertices.emplace_back(4 * (v + Vec(.5, .5, .5)));
  return shaken_case(Cage::make("integer-cube", vertices, cube.faces(), {}), {{2, 2, 2}, {1, 2, 2.5}, {2.5, 1.5, 1}});
}

/// The same with integer corners that twist all of its quads.
inline Case twisted_cube() {
  const Cage cube = integer_cube().cage;
  std::vector<Vec> vertices = cube.vertices();
  const std::vector<Vec> steps{{0, -1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, -1},
                               {-1, 0, 1}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] += steps[v];
  return shaken_case(Cage::make("twisted-cube", vertices, cube.faces(), {}), {{2, 2, 2}, {1, 2, 2.5}, {2.5, 1.5, 2}});
}

/// A twisted cube whose first face is a pyramid of four triangles outward.
inline Case mixed_cage() {
  const Cage cube = twisted_cube().cage;
  std::vector<Vec> vertices = cube.vertices();
  std::vector<Face> faces = cube.faces();
  const std::array<int, 4> base = faces.front().vertices;
  faces.erase(faces.begin());
  Vec middle = Vec::Zero(), inner = Vec::Zero();
  for (const int v : base) middle += vertices[v] / 4;
  for (const Vec& v : vertices) inner += v / 8;
  vertices.emplace_back((middle + (middle - inner) / 2).array().round());
  for (int k = 0; k < 4; ++k) faces.push_back({{base[k], base[(k + 1) % 4], 8, -1}});
  return shaken_case(Cage::make("mixed", vertices, faces, {}), {{2, 2, 2}, {1, 2, 2.5}, {2.5, 1.5, 2}});
}

inline std::vector<Case> quad_cases() { return {integer_cube(), twisted_cube(), mixed_cage()}; }

/// The deformers that keep quads, with parameters that decide what they take of a pose.
inline const std::vector<std::pair<const char*, std::vector<double>>>& quad_deformers() {
  static const std::vector<std::pair<const char*, std::vector<double>>> all{{"quad_green", {0}},
                                                                            {"quad_green", {1}},
                                                                            {"quad_green", {2}},
                                                                            {"quad_green", {3}},
                                                                            {"quad_green", {4}},
                                                                            {"quad_biharmonic_1_3", {1, 3, 1, 0}},
                                                                            {"quad_biharmonic_1_3", {1, 0, 1, 0}},
                                                                            {"quad_somigliana", {0, 0.3, 0, 0, 0.5}},
                                                                            {"quad_somigliana", {0, 0.3, 1, 0, 0.5}},
                                                                            {"quad_somigliana", {1, 0.3, 1, 0, 0.5}},
                                                                            {"quad_somigliana", {2, 0.3, 0, 0, 0.5}}};
  return all;
}

}  // namespace cageproof::deformation::test
