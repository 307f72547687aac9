// SPDX-License-Identifier: MIT
#include "space_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace cageproof::validation {
namespace {

// Moves each vertex to the mean of its neighbours, so many times: cubes of cells become smooth.
void smooth(Mesh& mesh, int times) {
  std::vector<std::vector<int>> beside(mesh.vertices.size());
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k) beside[face[k]].push_back(face[(k + 1) % face.size()]);
  for (int t = 0; t < times; ++t) {
    std::vector<Vec3<double>> moved(mesh.vertices.size(), Vec3<double>::Zero());
    for (std::size_t v = 0; v < moved.size(); ++v)
      for (const int w : beside[v]) moved[v] += mesh.vertices[w] / static_cast<double>(beside[v].size());
    mesh.vertices = std::move(moved);
  }
}

// A ring of so many vertices about z, the first on the x axis turned by half a step.
void add_ring(std::vector<Vec3<double>>& vertices, int count, double radius, double z) {
  for (int k = 0; k < count; ++k) {
    const double turn = 2 * std::numbers::pi * (k + 0.5) / count;
    vertices.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
  }
}

// Faces between successive rings, and a fan at each end, whose vertices follow the rings.
std::vector<std::vector<int>> ring_faces(int count, int rings) {
  std::vector<std::vector<int>> faces;
  const int below = count * rings, above = below + 1;
  for (int r = 0; r + 1 < rings; ++r)
    for (int k = 0; k < count; ++k) {
      const int a = r * count + k, b = r * count + (k + 1) % count;
      faces.push_back({a, b, b + count, a + count});
    }
  const int last = count * (rings - 1);
  for (int k = 0; k < count; ++k) {
    faces.push_back({below, (k + 1) % count, k});
    faces.push_back({above, last + k, last + (k + 1) % count});
  }
  return faces;
}

Cage cage_of_mesh(std::string name, const Mesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (const auto& face : mesh.faces) {
    Face made;
    std::ranges::copy(face, made.vertices.begin());
    faces.push_back(made);
  }
  return Cage::make(std::move(name), mesh.vertices, std::move(faces));
}

constexpr int pencil_sides = 6;
constexpr double tower_height = 0.8;

// Meshes of cells lie within their cages by so much, before smoothing draws them in further.
constexpr double mesh_inset = 0.06;

// The cells of a box, inset, whose middles a body holds; smoothed.
TonedMesh smooth_block(const std::array<std::array<double, 2>, 3>& reach, double step,
                       const std::function<bool(const Vec3<double>&)>& holds) {
  CellPlanes planes;
  for (std::size_t c = 0; c < 3; ++c) {
    const double first = reach[c][0] + mesh_inset, last = reach[c][1] - mesh_inset;
    const int count = static_cast<int>(std::lround((last - first) / step));
    for (int k = 0; k <= count; ++k) planes[c].push_back(first + (last - first) * k / count);
  }
  TonedMesh found;
  found.mesh = cell_surface(planes, [&](const std::array<int, 3>& cell) {
    Vec3<double> middle;
    for (int c = 0; c < 3; ++c) middle[c] = (planes[c][cell[c]] + planes[c][cell[c] + 1]) / 2;
    return holds(middle);
  });
  smooth(found.mesh, 3);
  found.tones.assign(found.mesh.faces.size(), 0);
  return found;
}

}  // namespace

Cage plain_bar(int pieces) {
  std::vector<double> along;
  for (int k = 0; k <= pieces; ++k) along.push_back(2.0 * k / pieces - 1);
  const Mesh mesh = cell_surface({{{-0.5, 0.5}, {-0.5, 0.5}, along}}, [](const auto&) { return true; });
  return cage_of_mesh("bar of " + std::to_string(pieces), mesh);
}

std::vector<Vec3<double>> twisted_about_z(std::vector<Vec3<double>> vertices, double angle) {
  for (Vec3<double>& p : vertices) {
    const double turn = angle * (p[2] + 1) / 2, c = std::cos(turn), s = std::sin(turn);
    p = Vec3<double>(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]);
  }
  return vertices;
}

Mesh cell_surface(const CellPlanes& planes, const std::function<bool(const std::array<int, 3>&)>& holds) {
  Mesh found;
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = known.try_emplace(at, static_cast<int>(found.vertices.size()));
    if (is_new) found.vertices.emplace_back(planes[0][at[0]], planes[1][at[1]], planes[2][at[2]]);
    return place->second;
  };
  const auto inside = [&](const std::array<int, 3>& cell) {
    for (std::size_t c = 0; c < 3; ++c)
      if (cell[c] < 0 || cell[c] + 1 >= static_cast<int>(planes[c].size())) return false;
    return holds(cell);
  };
  std::array<int, 3> cell{};
  for (cell[0] = 0; cell[0] + 1 < static_cast<int>(planes[0].size()); ++cell[0])
    for (cell[1] = 0; cell[1] + 1 < static_cast<int>(planes[1].size()); ++cell[1])
      for (cell[2] = 0; cell[2] + 1 < static_cast<int>(planes[2].size()); ++cell[2]) {
        if (!inside(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const bool far : {false, true}) {
            std::array<int, 3> next = cell;
            next[axis] += far ? 1 : -1;
            if (inside(next)) continue;
            std::vector<int> face;
            for (const auto& [du, dv] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
              std::array<int, 3> at = cell;
              at[axis] += far ? 1 : 0;
              at[(axis + 1) % 3] += du;
              at[(axis + 2) % 3] += dv;
              face.push_back(vertex(at));
            }
            if (!far) std::ranges::reverse(face);
            found.faces.push_back(std::move(face));
          }
      }
  return found;
}

Cage fork_cage() {
  const CellPlanes planes{{{-1, -0.12, 0.12, 1}, {-0.4, 0.4}, {0, 0.6, 2}}};
  return cage_of_mesh("fork", cell_surface(planes, [](const auto& c) { return c[0] != 1 || c[2] == 0; }));
}

TonedMesh fork_mesh(double step) {
  return smooth_block({{{-1, 1}, {-0.4, 0.4}, {0, 2}}}, step, [](const Vec3<double>& p) {
    return std::abs(p[0]) > 0.12 + mesh_inset || p[2] < 0.6 - mesh_inset;
  });
}

Cage tower_cage() {
  const CellPlanes planes{{{-1, -0.4, 0.4, 1}, {-1, -0.4, 0.4, 1}, {-1, 0, tower_height}}};
  Mesh mesh = cell_surface(planes, [](const auto& c) { return c[2] == 0 || (c[0] == 1 && c[1] == 1); });
  const double turn = 40 * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  for (Vec3<double>& p : mesh.vertices)
    if (p[2] == tower_height) p = Vec3<double>(c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]);
  return cage_of_mesh("tower", mesh);
}

TonedMesh tower_sheet(double step) {
  TonedMesh found = grid(2 * 0.92, 2 * 0.92, step);
  for (Vec3<double>& p : found.mesh.vertices) p -= Vec3<double>(0.92, 0.92, 0.1);
  found.mesh.segments.clear();
  found.tones.assign(found.mesh.faces.size(), 0);
  return found;
}

Cage pencil_cage() {
  Mesh mesh;
  for (const double z : {-1.0, -0.35, 0.3, 0.9}) add_ring(mesh.vertices, pencil_sides, 0.5, z);
  mesh.vertices.emplace_back(0, 0, -1.1);
  mesh.vertices.emplace_back(0, 0, 1.6);
  mesh.faces = ring_faces(pencil_sides, 4);
  return cage_of_mesh("pencil", mesh);
}

TonedMesh pencil_mesh(int around) {
  // Radius by z, within the cage's inscribed tube of 0.43 and its tip.
  const std::array<std::array<double, 2>, 6> profile{
      {{-1.0, 0.33}, {-0.95, 0.39}, {-0.88, 0.415}, {0.82, 0.415}, {0.92, 0.38}, {1.48, 0.05}}};
  const double step = 2 * std::numbers::pi * 0.415 / around;
  TonedMesh found;
  int rings = 0;
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const auto& [z, radius] = profile[k];
    const auto& [next_z, next_radius] = profile[k + 1];
    const int count = std::max(1, static_cast<int>(std::lround(std::hypot(next_z - z, next_radius - radius) / step)));
    for (int i = 0; i < count; ++i, ++rings)
      add_ring(found.mesh.vertices, around, radius + (next_radius - radius) * i / count, z + (next_z - z) * i / count);
  }
  add_ring(found.mesh.vertices, around, profile.back()[1], profile.back()[0]);
  ++rings;
  found.mesh.vertices.emplace_back(0, 0, -1.02);
  found.mesh.vertices.emplace_back(0, 0, 1.51);
  found.mesh.faces = ring_faces(around, rings);
  for (int r = 0; r + 1 < rings; ++r)
    for (int k = 0; k < around; ++k) found.tones.push_back(static_cast<char>((r / 2 + k / 2) % 2));
  found.tones.resize(found.mesh.faces.size(), 0);
  return found;
}

}  // namespace cageproof::validation
