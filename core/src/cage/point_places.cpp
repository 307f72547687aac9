// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/point_places.h"

#include "solid_angle_sum.h"

#include "cageproof/core/cage/enclosed.h"
#include "cageproof/core/cage/face_triangles.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cageproof {

struct PointPlaces::Asked {
  virtual ~Asked() = default;
  virtual bool is_closed() const = 0;
  virtual PointPlace at(const Vec3<double>& point) const = 0;
};

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct OfCage : PointPlaces::Asked {
  OfCage(const Cage& cage, bool keep_quads, Triangulation rule)
      : elements(cage, keep_quads, rule), windings(elements), faces(cage.parts(keep_quads, rule).face_of) {}

  bool is_closed() const override { return true; }
  PointPlace at(const Vec3<double>& point) const override {
    const auto winding = windings.around(point);
    if (winding) return {*winding != 0 ? Place::Inside : Place::Outside, -1, static_cast<double>(*winding), 0};
    int first = std::numeric_limits<int>::max();
    for (const Touching& touch : elements.touching(point)) first = std::min(first, faces[touch.element]);
    return {Place::On, first, kNan, 0};
  }

  CageElements elements;
  WindingNumbers windings;
  std::vector<int> faces;
};

std::vector<Triangle<double>> triangles_of(const std::vector<Vec3<double>>& vertices,
                                           const std::vector<std::vector<int>>& faces, std::vector<int>& face_of) {
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!vertices[v].allFinite()) throw InputError(fmt::format("vertex {} is not finite (vertices counted from 0)", v));
  std::vector<Triangle<double>> triangles;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Vec3<double>> corners;
    for (const int v : faces[f]) {
      if (v < 0 || static_cast<std::size_t>(v) >= vertices.size())
        throw InputError(fmt::format("face {}: index {} is out of range (faces and vertices counted from 0)", f, v));
      corners.push_back(vertices[v]);
    }
    if (corners.size() < 3)
      throw InputError(fmt::format("face {}: {} corners, not 3 or more (faces counted from 0)", f, corners.size()));
    const auto cut = triangles_of_face(corners);
    if (cut.empty()) throw InputError(fmt::format("face {} crosses itself or has no area (faces counted from 0)", f));
    for (const auto& [a, b, c] : cut) {
      const Triangle<double> t{corners[a], corners[b], corners[c]};
      if (on_a_line(t)) continue;
      triangles.push_back(t);
      face_of.push_back(static_cast<int>(f));
    }
  }
  return triangles;
}

std::vector<Box> boxes_around(const std::vector<Triangle<double>>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle<double>& t : triangles) boxes.push_back(box_of(t));
  return boxes;
}

struct OfFaces : PointPlaces::Asked {
  OfFaces(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces)
      : triangles(triangles_of(vertices, faces, face_of)),
        tree(boxes_around(triangles)),
        closed(cageproof::is_closed({faces, {}, 3})) {}

  bool is_closed() const override { return closed; }
  PointPlace at(const Vec3<double>& point) const override {
    int first = std::numeric_limits<int>::max();
    tree.for_each_meeting({point, point}, [&](int t) {
      if (face_of[t] < first && type_of(ElementKind::Triangle).contact(triangles[t], point).contact != Contact::Off)
        first = face_of[t];
      return true;
    });
    if (first != std::numeric_limits<int>::max()) return {Place::On, first, kNan, 0};
    const BoundedSum sum = solid_angles(triangles, point);
    double winding = sum.value / (4 * std::numbers::pi), bound = sum.bound / (4 * std::numbers::pi);
    if (closed && bound < 0.25) {
      winding = std::round(winding);
      bound = 0;
    }
    return {std::abs(winding) > 0.5 + bound ? Place::Inside : Place::Outside, -1, winding, bound};
  }

  std::vector<int> face_of;  // of triangles, which fill it
  std::vector<Triangle<double>> triangles;
  BoxTree tree;
  bool closed;
};

}  // namespace

std::string_view name_of(Place place) {
  switch (place) {
    case Place::Inside: return "inside";
    case Place::On: return "on";
    case Place::Outside: break;
  }
  return "outside";
}

PointPlaces::PointPlaces(const Cage& cage, bool keep_quads, Triangulation rule)
    : asked_(std::make_shared<OfCage>(cage, keep_quads, rule)) {}

PointPlaces::PointPlaces(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces)
    : asked_(std::make_shared<OfFaces>(vertices, faces)) {}

bool PointPlaces::is_closed() const { return asked_->is_closed(); }

PointPlace PointPlaces::at(const Vec3<double>& point) const {
  // Exact predicates want numbers.
  if (!point.allFinite()) return {Place::Outside, -1, kNan, 0};
  return asked_->at(point);
}

}  // namespace cageproof
