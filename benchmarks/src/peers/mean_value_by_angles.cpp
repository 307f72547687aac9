// SPDX-License-Identifier: MIT
#include "peers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::benchmarks {

// Ju, Schaefer and Warren 2005, Section 3.3, for points off the faces. The thresholds decide when the paper's branches
// for points on a face, and for points in a triangle's plane, are taken.
PeerFill mean_value_by_angles(const CageElements& elements) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(elements.count());
  for (std::size_t t = 0; t < elements.count(); ++t) {
    const auto of = elements.vertices_of(t);
    triangles.push_back({of[0], of[1], of[2]});
  }
  return [triangles, vertices = elements.vertices()](std::span<const Vec3<double>> points, std::span<double> values) {
    constexpr double threshold = 1e-12;
    const std::size_t count = vertices.size();
    std::vector<Vec3<double>> direction(count);
    std::vector<double> distance(count);
    for (std::size_t p = 0; p < points.size(); ++p) {
      double* const row = values.data() + p * count;
      std::fill_n(row, count, 0.);
      for (std::size_t v = 0; v < count; ++v) {
        direction[v] = vertices[v] - points[p];
        distance[v] = direction[v].norm();
        direction[v] /= distance[v];
      }
      double sum = 0;
      for (const std::array<int, 3>& corner : triangles) {
        std::array<double, 3> angle{}, cosine{}, sine{};
        double half = 0;
        for (int k = 0; k < 3; ++k) {
          const double chord = (direction[corner[(k + 1) % 3]] - direction[corner[(k + 2) % 3]]).norm();
          angle[k] = 2 * std::asin(chord / 2);
          half += angle[k] / 2;
        }
        const double turn = direction[corner[0]].dot(direction[corner[1]].cross(direction[corner[2]])) < 0 ? -1. : 1.;
        bool is_in_plane = false;
        for (int k = 0; k < 3; ++k) {
          const int next = (k + 1) % 3, last = (k + 2) % 3;
          cosine[k] =
              2 * std::sin(half) * std::sin(half - angle[k]) / (std::sin(angle[next]) * std::sin(angle[last])) - 1;
          sine[k] = turn * std::sqrt(std::max(0., 1 - cosine[k] * cosine[k]));
          is_in_plane |= std::abs(sine[k]) <= threshold;
        }
        if (is_in_plane) continue;
        for (int k = 0; k < 3; ++k) {
          const int next = (k + 1) % 3, last = (k + 2) % 3;
          const double weight = (angle[k] - cosine[next] * angle[last] - cosine[last] * angle[next]) /
                                (distance[corner[k]] * std::sin(angle[next]) * sine[last]);
          row[corner[k]] += weight;
          sum += weight;
        }
      }
      for (std::size_t v = 0; v < count; ++v) row[v] /= sum;
    }
  };
}

}  // namespace cageproof::benchmarks
