// SPDX-License-Identifier: MIT
#include "thinness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

double aspect_of(const CageElements& elements, std::size_t e) {
  const auto vertices = elements.vertices_of(e);
  if (vertices.size() != 3) return 1;
  const auto at = [&](int k) { return elements.vertices()[vertices[k % 3]]; };
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (at(k + 1) - at(k)).stableNorm());
  const Vec3<double> u = (at(1) - at(0)) / longest, v = (at(2) - at(0)) / longest;
  return 1 / u.cross(v).norm();
}

Thinness thinness_in_space(const CageElements& elements) {
  Thinness found{.times = 0};
  for (std::size_t e = 0; e < elements.count(); ++e)
    if (const double aspect = aspect_of(elements, e); !(aspect <= found.times)) found.times = aspect, found.element = e;
  found.what = fmt::format("is {:.2g} times as long as high", found.times);
  return found;
}

double distance_from(const Vec3<double>& from, const Vec3<double>& to, const Vec3<double>& point) {
  const Vec3<double> along = to - from, step = point - from;
  const double length = along.stableNorm();
  if (!(length > 0)) return step.stableNorm();
  return (step - std::clamp(step.dot(along / length), 0., length) * (along / length)).stableNorm();
}

struct NearestVertex {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t edge = 0, vertex = 0;
};

// The vertex and the edge next to each other; the vertex is no end of the edge.
NearestVertex nearest_in(const CageElements& elements) {
  NearestVertex found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto ends = elements.vertices_of(e);
    for (std::size_t v = 0; v < elements.vertices().size(); ++v) {
      if (static_cast<int>(v) == ends[0] || static_cast<int>(v) == ends[1]) continue;
      const double distance =
          distance_from(elements.vertices()[ends[0]], elements.vertices()[ends[1]], elements.vertices()[v]);
      if (!(distance >= found.distance)) found = {distance, e, v};
    }
  }
  return found;
}

struct Edges {
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
  std::size_t element = 0;  // with the shortest
};

Edges edges_of(const CageElements& elements) {
  Edges found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    // A segment has one edge.
    const std::size_t edges = vertices.size() == 2 ? 1 : vertices.size();
    for (std::size_t k = 0; k < edges; ++k) {
      const Vec3<double>& from = elements.vertices()[vertices[k]];
      const double length = (elements.vertices()[vertices[(k + 1) % vertices.size()]] - from).stableNorm();
      found.longest = std::max(found.longest, length);
      if (!(length >= found.shortest)) found.shortest = length, found.element = e;
    }
  }
  return found;
}

Thinness short_edge(const Edges& edges, std::string_view verb) {
  const double times = edges.longest / edges.shortest;
  return {times, edges.element, fmt::format("{} {:.2g} times shorter than the longest edge", verb, times)};
}

Thinness thinness_in_plane(const CageElements& elements) {
  const Edges edges = edges_of(elements);
  const NearestVertex nearest = nearest_in(elements);
  // A short edge's neighbours are as near to its ends.
  if (!(nearest.distance < edges.shortest / 2)) return short_edge(edges, "is");
  const double times = edges.longest / nearest.distance;
  return {times, nearest.edge,
          fmt::format("is {:.2g} times nearer to vertex {} than the longest edge is long", times, nearest.vertex)};
}

}  // namespace

Thinness thinness_of(const CageElements& elements) {
  return elements.dimension() == 2 ? thinness_in_plane(elements) : thinness_in_space(elements);
}

Thinness smallness_of(const CageElements& elements) {
  return short_edge(edges_of(elements), elements.dimension() == 2 ? "is" : "has an edge");
}

}  // namespace cageproof::deformation
