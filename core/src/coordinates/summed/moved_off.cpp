// SPDX-License-Identifier: MIT
#include "moved_off.h"

#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <optional>

namespace cageproof {
namespace {

using Number = Mp200;
using Corners3 = std::vector<Vec3<Number>>;

// Distances over the shortest edge. Those below kTooNear are made larger. The distances from a vertex, an edge and a
// face each are so much less than the one before that only the nearest counts, and at most 1e-20 of a derivative is
// lost.
const Number kTooNear("1e-60"), kFromVertex("1e-20"), kFromEdge("1e-40"), kFromFace("1e-60"), kApart("1e-20");

Number length_of(const Vec3<Number>& x) { return sqrt(Number(x.dot(x))); }

Number shortest_edge(const std::vector<Corners3>& elements) {
  std::optional<Number> shortest;
  for (const Corners3& corners : elements)
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Number length = length_of(corners[(k + 1) % corners.size()] - corners[k]);
      if (!shortest || length < *shortest) shortest = length;
    }
  return *shortest;
}

struct NearPlace {
  Vec3<Number> place;
  Number distance;
};

// The nearer of two, the second of which there may not be.
void keep_nearer(const Vec3<Number>& place, const Vec3<Number>& point, std::optional<NearPlace>& best) {
  const Number distance = length_of(point - place);
  if (!best || distance < best->distance) best = NearPlace{place, distance};
}

NearPlace nearest_vertex(const std::vector<Corners3>& elements, const Vec3<Number>& point) {
  std::optional<NearPlace> best;
  for (const Corners3& corners : elements)
    for (const Vec3<Number>& corner : corners) keep_nearer(corner, point, best);
  return *best;
}

// The nearest foot within an edge; the nearest vertex stands for feet beyond the ends.
std::optional<NearPlace> nearest_edge(const std::vector<Corners3>& elements, const Vec3<Number>& point) {
  std::optional<NearPlace> best;
  for (const Corners3& corners : elements)
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3<Number> along = corners[(k + 1) % corners.size()] - corners[k];
      const Number share = Number((point - corners[k]).dot(along)) / Number(along.dot(along));
      if (share > Number(0) && share < Number(1)) keep_nearer(Vec3<Number>(corners[k] + share * along), point, best);
    }
  return best;
}

// The nearest foot within a triangle.
std::optional<NearPlace> nearest_face(const std::vector<Corners3>& elements, const Vec3<Number>& point) {
  std::optional<NearPlace> best;
  for (const Corners3& corners : elements) {
    const Vec3<Number> normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Number square = normal.dot(normal);
    const Vec3<Number> foot = point - (Number((point - corners[0]).dot(normal)) / square) * normal;
    bool within = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<Number> along = corners[(k + 1) % 3] - corners[k];
      within = within && Number(along.cross(Vec3<Number>(foot - corners[k])).dot(normal)) >= Number(0);
    }
    if (within) keep_nearer(foot, point, best);
  }
  return best;
}

}  // namespace

MovedOff moved_off(const std::vector<Corners3>& elements, const Vec3<Number>& point) {
  MovedOff moved{point};
  const bool in_plane = elements.front().size() == 2;
  const Number unit = shortest_edge(elements);
  const auto move_from = [&](const NearPlace& near, const Number& to) {
    const Number times = to / near.distance;
    moved.point = near.place + times * (moved.point - near.place);
    return times;
  };
  NearPlace vertex = nearest_vertex(elements, moved.point);
  if (vertex.distance < kTooNear * unit) {
    moved.further *= move_from(vertex, kFromVertex * unit);
    vertex = nearest_vertex(elements, moved.point);
  }
  // The distance of a vertex, than which edges and faces count only where they are much nearer.
  Number least = kApart * vertex.distance;
  if (!in_plane) {
    if (auto edge = nearest_edge(elements, moved.point)) {
      const Number to = std::min(Number(kFromEdge * unit), least);
      if (edge->distance < kTooNear * unit && edge->distance < to) {
        moved.further *= move_from(*edge, to);
        edge->distance = to;
      }
      least = std::min(least, Number(kApart * edge->distance));
    }
  }
  // In the plane edges are what faces are in space: coordinates are smooth up to them.
  const auto face = in_plane ? nearest_edge(elements, moved.point) : nearest_face(elements, moved.point);
  const Number to = std::min(Number(kFromFace * unit), least);
  if (face && face->distance < to) move_from(*face, to);
  return moved;
}

}  // namespace cageproof
