// SPDX-License-Identifier: MIT
#include "figure_shapes.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cageproof::validation {
namespace {

using FigurePoints = std::vector<Vec3<double>>;

constexpr int bar_rings = 5;

// Moves a point on a box's surface to the rounded box.
Vec3<double> with_round_edges(const Vec3<double>& point, const Vec3<double>& half, double radius) {
  const Vec3<double> core = half - Vec3<double>::Constant(radius);
  const Vec3<double> within = point.cwiseMin(core).cwiseMax(-core);
  const Vec3<double> beyond = point - within;
  return beyond.norm() > 0 ? Vec3<double>(within + radius * beyond.normalized()) : point;
}

}  // namespace

TonedMesh rounded_box(const Vec3<double>& half, double radius, double step) {
  TonedMesh found;
  // Even numbers of steps, so that the middle lies between squares of a colour.
  std::array<int, 3> steps{};
  for (int c = 0; c < 3; ++c) steps[c] = 2 * std::max(2, static_cast<int>(std::lround(half[c] / step)));
  std::map<std::array<int, 3>, int> known;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = known.try_emplace(at, static_cast<int>(found.mesh.vertices.size()));
    if (is_new) {
      Vec3<double> point;
      // Counted from the middle, so that mirror images are exact.
      for (int c = 0; c < 3; ++c) point[c] = half[c] * (2.0 * at[c] - steps[c]) / steps[c];
      found.mesh.vertices.push_back(with_round_edges(point, half, radius));
    }
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool far : {false, true})
      for (int i = 0; i < steps[u]; ++i)
        for (int j = 0; j < steps[v]; ++j) {
          std::vector<int> face;
          for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> at{};
            at[axis] = far ? steps[axis] : 0;
            at[u] = i + di;
            at[v] = j + dj;
            face.push_back(vertex(at));
          }
          if (!far) std::ranges::reverse(face);
          found.mesh.faces.push_back(std::move(face));
          found.tones.push_back(static_cast<char>((i / 2 + j / 2) % 2));
        }
  }
  return found;
}

TonedMesh grid(double width, double height, double step) {
  TonedMesh found;
  const int across = static_cast<int>(std::lround(width / step)), up = static_cast<int>(std::lround(height / step));
  for (int j = 0; j <= up; ++j)
    for (int i = 0; i <= across; ++i) found.mesh.vertices.emplace_back(width * i / across, height * j / up, 0);
  for (int j = 0; j < up; ++j)
    for (int i = 0; i < across; ++i) {
      const int first = j * (across + 1) + i;
      found.mesh.faces.push_back({first, first + 1, first + across + 2, first + across + 1});
      found.tones.push_back(static_cast<char>((i / 2 + j / 2) % 2));
    }
  found.mesh.segments.reserve(across);
  for (int i = 0; i < across; ++i) {
    const int first = up / 2 * (across + 1) + i;
    found.mesh.segments.push_back({first, first + 1});
  }
  return found;
}

Cage bar_cage() {
  FigurePoints vertices;
  for (int ring = 0; ring < bar_rings; ++ring)
    for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
      vertices.emplace_back(x, y, -1 + 0.5 * ring);
  return Cage::make("bar", std::move(vertices), embedded_cage("twisted-bar").faces());
}

FigurePoints bent_about_y(FigurePoints points, double angle, double length) {
  const double radius = 2 * length / angle;
  for (Vec3<double>& p : points) {
    const double turn = 0.5 * angle * p[2], out = radius - p[0];
    p = Vec3<double>(radius - out * std::cos(turn), p[1], out * std::sin(turn));
  }
  return points;
}

FigurePoints bent_bar(double angle, double length) { return bent_about_y(bar_cage().vertices(), angle, length); }

FigurePoints twisted_bar_pose() { return embedded_cage("twisted-bar").vertices(); }

Cage plane_bar() {
  FigurePoints vertices;
  for (int i = 0; i <= 6; ++i) vertices.emplace_back(i, 0, 0);
  vertices.emplace_back(6, 1, 0);
  for (int i = 6; i >= 0; --i) vertices.emplace_back(i, 2, 0);
  vertices.emplace_back(0, 1, 0);
  const int count = static_cast<int>(vertices.size());
  std::vector<Face> segments;
  segments.reserve(count);
  for (int k = 0; k < count; ++k) segments.push_back({{k, (k + 1) % count, -1, -1}});
  return Cage::make_polygon("bar", std::move(vertices), std::move(segments));
}

Vec3<double> bent_in_plane(const Vec3<double>& p, double angle) {
  const double radius = 6 / angle, turn = (p[0] - 3) / radius, out = radius + p[1] - 1;
  return {3 + out * std::sin(turn), 1 - radius + out * std::cos(turn), 0};
}

}  // namespace cageproof::validation
