// SPDX-License-Identifier: MIT
#include "geometry.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/mp.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::adaptive_qmvc::batch {
namespace {

void put(double (&to)[3], const Vec3<Mp50>& from) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<double>(from[i]);
}

QuadTable table_of(const std::array<Vec3<Mp50>, 4>& q, const std::array<int, 4>& vertices, double sign) {
  const Vec3<Mp50> e = q[1] - q[0], b = q[3] - q[0], w = (q[2] - q[1]) - b;
  const Vec3<Mp50> n_u = Mp50(sign) * e.cross(w);
  QuadTable t{};
  put(t.origin, q[0]);
  put(t.e, e);
  put(t.b, b);
  put(t.w, w);
  const Vec3<Mp50> n = Mp50(sign) * e.cross(b);
  put(t.n, n);
  for (int i = 0; i < 3; ++i) {
    t.n_high[i] = static_cast<float>(t.n[i]);
    t.n_rest[i] = static_cast<double>(Mp50(n[i] - t.n_high[i]));
  }
  put(t.n_u, n_u);
  put(t.n_v, Mp50(sign) * w.cross(b));
  t.twist = static_cast<double>(Mp50(b.dot(n_u)));
  std::ranges::copy(vertices, t.vertex);
  return t;
}

}  // namespace

void Geometry::find_unit(const CageElements& elements) {
  const auto [low, high] = box_of(elements.vertices());
  const double size = (high / 2 - low / 2).cwiseAbs().maxCoeff();
  sound_ = size > 0 && std::isfinite(size);
  if (!sound_) return;
  exponent_ = std::ilogb(size) + 1;
  for (const Vec3<double>& v : elements.vertices()) {
    Vec3<double>& scaled = vertex_.emplace_back();
    for (int i = 0; i < 3; ++i) scaled[i] = std::ldexp(v[i], -exponent_);
  }
}

int Geometry::edge_between(int from, int to) {
  const Vec3<double> start = vertex_[from], along = vertex_[to] - start;
  const double square = along.dot(along);
  EdgeTable& edge = edges_.emplace_back();
  for (int i = 0; i < 3; ++i) edge.from[i] = start[i], edge.along[i] = along[i];
  edge.over2 = square > 0 ? 1 / square : 0;
  return static_cast<int>(edges_.size()) - 1;
}

void Geometry::add_face(std::array<int, 4> corners) {
  std::array<Vec3<Mp50>, 4> q;
  for (int k = 0; k < 4; ++k) q[k] = convert<Mp50>(vertex_[corners[k]]);
  FaceTables& face = faces_.emplace_back();
  face.along = table_of(q, corners, 1);
  std::swap(q[1], q[3]);
  std::swap(corners[1], corners[3]);
  face.turned = table_of(q, corners, -1);
}

Geometry::Geometry(const CageElements& elements) {
  find_unit(elements);
  if (!sound_) return;
  std::map<std::array<int, 2>, int> numbers;
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const auto of_face = elements.vertices_of(f);
    const std::array<int, 4> corners{of_face[0], of_face[1], of_face[2], of_face.size() == 4 ? of_face[3] : of_face[2]};
    add_face(corners);
    FaceTables& face = faces_.back();
    std::array<double, 4> length{};
    for (int i = 0; i < 4; ++i) {
      const int from = corners[i], to = corners[(i + 1) % 4];
      const auto [place, added] = numbers.try_emplace({std::min(from, to), std::max(from, to)}, 0);
      if (added) place->second = edge_between(from, to);
      face.edge[i] = place->second;
      length[i] = (vertex_[from] - vertex_[to]).norm();
    }
    const double u = std::max(length[0], length[2]), v = std::max(length[1], length[3]);
    face.over_u = 1 / u;
    face.over_v = 1 / v;
    // A face with two opposite sides of length zero has no area.
    sound_ = sound_ && std::isfinite(face.over_u) && std::isfinite(face.over_v);
  }
}

}  // namespace cageproof::adaptive_qmvc::batch
