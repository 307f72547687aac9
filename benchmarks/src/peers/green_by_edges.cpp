// SPDX-License-Identifier: MIT
#include "peers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::benchmarks {
namespace {

struct Side {
  Vec3<double> outward;  // within the plane
  double length;
  double height;  // of the corner that is not on the side
};

struct Triangle {
  std::array<int, 3> vertices;
  Vec3<double> normal;
  std::array<Side, 3> sides;  // from corner k to k + 1
};

std::vector<Triangle> triangles_of(const CageElements& elements) {
  std::vector<Triangle> triangles;
  triangles.reserve(elements.count());
  for (std::size_t t = 0; t < elements.count(); ++t) {
    const auto of = elements.vertices_of(t);
    Triangle& triangle = triangles.emplace_back();
    std::array<Vec3<double>, 3> x;
    for (int k = 0; k < 3; ++k) {
      triangle.vertices[k] = of[k];
      x[k] = elements.vertices()[of[k]];
    }
    const Vec3<double> area = (x[1] - x[0]).cross(x[2] - x[0]);
    triangle.normal = area.normalized();
    for (int k = 0; k < 3; ++k) {
      const Vec3<double> along = x[(k + 1) % 3] - x[k];
      const double length = along.norm();
      triangle.sides[k] = {along.cross(triangle.normal) / length, length, area.norm() / length};
    }
  }
  return triangles;
}

}  // namespace

// The solid angle after Van Oosterom and Strackee, a logarithm per edge after Wilton et al. and Graglia; no element is
// told apart from another, so that on planes of elements 0 log 0 may come up.
PeerFill green_by_edges(const CageElements& elements) {
  const std::size_t vertices = elements.vertices().size(), width = vertices + elements.count();
  return [triangles = triangles_of(elements), corners = elements.vertices(), vertices, width](
             std::span<const Vec3<double>> points, std::span<double> values) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      double* const row = values.data() + p * width;
      std::fill_n(row, width, 0.);
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        std::array<Vec3<double>, 3> x;
        std::array<double, 3> r{};
        for (int k = 0; k < 3; ++k) {
          x[k] = corners[triangle.vertices[k]] - points[p];
          r[k] = x[k].norm();
        }
        const double height = triangle.normal.dot(x[0]);
        const double angle =
            2 * std::atan2(x[0].dot(x[1].cross(x[2])),
                           r[0] * r[1] * r[2] + x[0].dot(x[1]) * r[2] + x[1].dot(x[2]) * r[0] + x[2].dot(x[0]) * r[1]);
        std::array<double, 3> distance{}, logarithm{};
        double single = -height * angle;
        for (int k = 0; k < 3; ++k) {
          const Side& side = triangle.sides[k];
          const double ends = r[k] + r[(k + 1) % 3];
          distance[k] = side.outward.dot(x[k]);
          logarithm[k] = std::log((ends + side.length) / (ends - side.length));
          single += distance[k] * logarithm[k];
        }
        for (int k = 0; k < 3; ++k) {
          // The hat function falls from the corner towards the side opposite.
          const int opposite = (k + 1) % 3;
          const Side& side = triangle.sides[opposite];
          double slopes = 0;
          for (int e = 0; e < 3; ++e) slopes += side.outward.dot(triangle.sides[e].outward) * logarithm[e];
          row[triangle.vertices[k]] +=
              (distance[opposite] * angle + height * slopes) / (4 * std::numbers::pi * side.height);
        }
        row[vertices + t] = single / (4 * std::numbers::pi);
      }
    }
  };
}

}  // namespace cageproof::benchmarks
