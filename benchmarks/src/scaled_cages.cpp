// SPDX-License-Identifier: MIT
#include "scaled_cages.h"

#include "cageproof/core/numbers/scalar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::benchmarks {
namespace {

// Each face cut in four, at the midpoints of edges and, of quads, of faces.
Cage cut_in_four(const Cage& coarse) {
  std::vector<Vec3<double>> vertices = coarse.vertices();
  std::map<std::vector<int>, int> midpoints;
  const auto middle_of = [&](std::vector<int> of) {
    std::ranges::sort(of);
    const auto [found, is_new] = midpoints.try_emplace(of, static_cast<int>(vertices.size()));
    if (is_new) {
      Vec3<double> sum = Vec3<double>::Zero();
      for (const int v : of) sum += vertices[v];
      vertices.push_back(sum / static_cast<double>(of.size()));
    }
    return found->second;
  };
  std::vector<Face> faces;
  faces.reserve(4 * coarse.faces().size());
  for (const Face& face : coarse.faces()) {
    const int corners = face.size();
    std::array<int, 4> middles{};
    for (int k = 0; k < corners; ++k) middles[k] = middle_of({face.vertices[k], face.vertices[(k + 1) % corners]});
    if (corners == 3) faces.push_back({{middles[0], middles[1], middles[2], -1}});
    for (int k = 0; k < corners; ++k) {
      const int last = middles[(k + corners - 1) % corners];
      if (corners == 3) faces.push_back({{face.vertices[k], middles[k], last, -1}});
      else
        faces.push_back({{face.vertices[k], middles[k],
                          middle_of({face.vertices[0], face.vertices[1], face.vertices[2], face.vertices[3]}), last}});
    }
  }
  return coarse.with(vertices, faces);
}

// Points drawn towards the origin, which is inside: off the faces and not beyond them, as most points of a mesh are.
DeformedCage coarsest(
    std::string_view cage, int points, const ScaledCages::Shape& shape = [](const Vec3<double>& p) { return p; }) {
  DeformedCage found = embedded_deformed_cage(cage, points);
  for (Vec3<double>& p : found.points) p = shape(0.5 * p);
  return found;
}

}  // namespace

std::size_t ScaledCages::faces(int times, bool keeps_quads) const {
  std::size_t count = 0;
  for (const Face& face : coarsest_.cage.faces()) count += keeps_quads || face.size() == 3 ? 1 : 2;
  return count << (2 * times);
}

std::string ScaledCages::name(int times, bool keeps_quads) const {
  return fmt::format("{}{}", label_, faces(times, keeps_quads));
}

std::shared_ptr<const DeformedCage> ScaledCages::cut(int times) const {
  if (cages_.empty()) cages_.push_back(coarsest_.cage);
  while (cages_.size() <= static_cast<std::size_t>(times)) cages_.push_back(cut_in_four(cages_.back()));
  const Cage& flat = cages_[times];
  std::vector<Vec3<double>> vertices = flat.vertices();
  std::ranges::transform(vertices, vertices.begin(), shape_);
  return std::make_shared<const DeformedCage>(DeformedCage{fmt::format("{}-{}", coarsest_.name, flat.faces().size()),
                                                           flat.with(vertices, flat.faces()), vertices,
                                                           coarsest_.points});
}

ScaledCages cubes(int points) { return {"", coarsest("cube", points)}; }

ScaledCages spheres(int points) {
  return {"", coarsest("icosphere", points), [](const Vec3<double>& v) { return Vec3<double>(v.normalized()); }};
}

ScaledCages long_spheres(int points) {
  const auto stretched = [](const Vec3<double>& v) { return Vec3<double>(v[0], v[1], 16 * v[2]); };
  return {"long-", coarsest("icosphere", points, stretched),
          [=](const Vec3<double>& v) { return stretched(v.normalized()); }};
}

ScaledCages graded_spheres(int points) {
  // By the angle from the pole, whose cube leaves small what is small.
  return {"graded-", coarsest("icosphere", points), [](const Vec3<double>& v) {
            const double flat = std::hypot(v[0], v[1]), angle = std::atan2(flat, v[2]) / pi<double>();
            if (flat == 0) return Vec3<double>(v.normalized());
            const double moved = pi<double>() * angle * angle * angle;
            return Vec3<double>(std::sin(moved) * v[0] / flat, std::sin(moved) * v[1] / flat, std::cos(moved));
          }};
}

}  // namespace cageproof::benchmarks
