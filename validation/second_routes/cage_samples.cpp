// SPDX-License-Identifier: MIT
#include "cage_samples.h"

#include <cmath>

namespace cageproof::second_routes {
namespace {

using Barycentric = std::array<double, 3>;

Barycentric between(const Barycentric& a, const Barycentric& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

using Part = std::vector<Barycentric>;

// Halves of a segment, or the four triangles between the corners and the midpoints of a triangle.
std::vector<Part> parts_of(const Part& whole) {
  const Barycentric middle = between(whole[0], whole[1]);
  if (whole.size() == 2) return {{whole[0], middle}, {middle, whole[1]}};
  const Barycentric after = between(whole[1], whole[2]), before = between(whole[2], whole[0]);
  return {{middle, after, before}, {whole[0], middle, before}, {middle, whole[1], after}, {before, after, whole[2]}};
}

}  // namespace

std::vector<Touching> centroids(const CageElements& elements, int level) {
  std::vector<Touching> found;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    const std::size_t corners = vertices.size();
    std::size_t last = 0;
    for (std::size_t k = 1; k < corners; ++k)
      if (vertices[k] < vertices[last]) last = k;
    std::vector<Part> parts{{{1, 0, 0}, {0, 1, 0}}};
    if (corners == 3) parts.front().push_back({0, 0, 1});
    for (int k = 0; k < level; ++k) {
      std::vector<Part> smaller;
      for (const Part& part : parts)
        for (Part& piece : parts_of(part)) smaller.push_back(std::move(piece));
      parts = std::move(smaller);
    }
    for (const Part& part : parts) {
      // Sums of halves of halves are exact. Multiples of 2^-52 leave one of one.
      Touching& sample = found.emplace_back(Touching{static_cast<int>(e), {}});
      double left = 1;
      for (std::size_t k = 0; k < corners; ++k) {
        if (k == last) continue;
        double sum = 0;
        for (const Barycentric& corner : part) sum += corner[k];
        sample.basis[k] = std::ldexp(std::round(std::ldexp(sum / static_cast<double>(corners), 52)), -52);
        left -= sample.basis[k];
      }
      sample.basis[last] = left;
    }
  }
  return found;
}

std::vector<Wide> basis_of(const CageElements& elements, const Touching& sample) {
  std::vector<Wide> basis(elements.vertices_of(sample.element).size());
  basis[0] = 1;
  for (std::size_t k = 1; k < basis.size(); ++k) {
    basis[k] = sample.basis[k];
    basis[0] -= basis[k];
  }
  return basis;
}

Table<Wide> hat_functions(const CageElements& elements, const std::vector<Touching>& samples) {
  Table<Wide> hats(samples.size(), elements.vertices().size());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const std::vector<Wide> basis = basis_of(elements, samples[s]);
    const auto corners = elements.vertices_of(samples[s].element);
    for (std::size_t k = 0; k < basis.size(); ++k) hats(s, corners[k]) = basis[k];
  }
  return hats;
}

SampledLayerRows::SampledLayerRows(const CageCoordinates& layers, const std::vector<Touching>& samples, int order) {
  const auto tables = layers.limits_at<Mp50>(samples, order);
  const std::size_t width = derivative_count(layers.dimension(), order);
  for (std::size_t which = 0; which < width; ++which) {
    std::vector<Table<Wide>> rows;
    for (const CoordinateTable<Mp50>& table : tables) {
      Table<Wide>& block = rows.emplace_back(samples.size(), table.stride[order] / width);
      for (std::size_t s = 0; s < samples.size(); ++s)
        for (std::size_t i = 0; i < block.columns; ++i)
          block(s, i) = table.tensors[order][s * table.stride[order] + i * width + which];
    }
    derivatives.push_back({rows[0], rows[1], rows[2], rows[3]});
  }
}

Vec3<Wide> unit_normal_of(const CageElements& elements, const std::vector<Vec3<double>>& vertices,
                          std::size_t element) {
  const auto corners = elements.vertices_of(element);
  const auto edge = [&](std::size_t k) {
    return Vec3<Wide>(convert<Wide>(vertices[corners[k]]) - convert<Wide>(vertices[corners[0]]));
  };
  const Vec3<Wide> u = edge(1);
  Vec3<Wide> normal(u[1], -u[0], Wide(0));
  if (corners.size() == 3) normal = u.cross(edge(2));
  return normal / Wide(sqrt(Wide(normal.dot(normal))));
}

}  // namespace cageproof::second_routes
