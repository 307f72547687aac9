// SPDX-License-Identifier: MIT
#include "thickness_energy.h"

namespace cageproof::second_routes {

ThicknessEnergy::ThicknessEnergy(const CageCoordinates& coordinates, int samples, const std::vector<Vec3<double>>& at)
    : elements_(coordinates.elements()) {
  std::vector<Touching> places;
  for (std::size_t e = 0; e < elements_.count(); ++e)
    for (int q = 0; q < samples; ++q) {
      const double along = (q + 0.5) / samples;
      places.push_back({static_cast<int>(e), {1 - along, along, 0, 0}});
    }
  const auto second = coordinates.limits_at<double>(places, 2);
  for (std::size_t s = 0; s < places.size(); ++s) {
    const std::vector<Vec3<double>> ends = elements_.corners(static_cast<std::size_t>(places[s].element));
    const Vec3<Mp50> edge = convert<Mp50>(ends[1]) - convert<Mp50>(ends[0]);
    const Mp50 square = edge.dot(edge);
    // n n^T times the square of the edge's length: of (y, -x).
    const std::array<Mp50, 4> across{edge[1] * edge[1], -edge[0] * edge[1], -edge[0] * edge[1], edge[0] * edge[0]};
    const auto along_normal = [&](const CoordinateTable<double>& table) {
      std::vector<Mp50> found(table.stride[2] / 4);
      for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
          found[i] += across[k] * table.tensors[2][s * table.stride[2] + 4 * i + k] / square;
      return found;
    };
    bending_.push_back({along_normal(second[0]), along_normal(second[1])});
  }
  for (const Vec3<double>& point : at) {
    const auto values = coordinates.at<double>(point, 0);
    positions_.push_back(
        {{values[0].value.begin(), values[0].value.end()}, {values[1].value.begin(), values[1].value.end()}});
  }
}

std::array<Mp50, 2> ThicknessEnergy::at_row(const Row& row, const Unknowns& vertices) const {
  std::array<Mp50, 2> sum;
  for (std::size_t i = 0; i < row.of_vertices.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) sum[c] += row.of_vertices[i] * vertices[2 * i + c];
  for (std::size_t e = 0; e < row.of_normals.size(); ++e) {
    const auto ends = elements_.vertices_of(e);
    const auto from = 2 * static_cast<std::size_t>(ends[0]), to = 2 * static_cast<std::size_t>(ends[1]);
    const Mp50 x = vertices[to] - vertices[from], y = vertices[to + 1] - vertices[from + 1],
               length = sqrt(Mp50(x * x + y * y));
    sum[0] += row.of_normals[e] * y / length;
    sum[1] -= row.of_normals[e] * x / length;
  }
  return sum;
}

Mp50 ThicknessEnergy::of(const Unknowns& vertices) const {
  Mp50 sum = 0;
  for (const Row& row : bending_)
    for (const Mp50& x : at_row(row, vertices)) sum += x * x;
  return sum;
}

std::vector<Mp50> ThicknessEnergy::images(const Unknowns& vertices) const {
  std::vector<Mp50> found;
  for (const Row& row : positions_)
    for (const Mp50& x : at_row(row, vertices)) found.push_back(x);
  return found;
}

double ThicknessEnergy::slope_along_constraints(const Unknowns& vertices) const {
  const Mp50 step("1e-14");
  const std::size_t n = vertices.size(), constraints = 2 * positions_.size();
  std::vector<Mp50> gradient(n);
  Table<Mp50> of_images(constraints, n);
  for (std::size_t k = 0; k < n; ++k) {
    Unknowns after = vertices, before = vertices;
    after[k] += step;
    before[k] -= step;
    gradient[k] = (of(after) - of(before)) / (2 * step);
    const std::vector<Mp50> there = images(after), here = images(before);
    for (std::size_t c = 0; c < constraints; ++c) of_images(c, k) = (there[c] - here[c]) / (2 * step);
  }
  // g - C^T (C C^T)^-1 C g.
  Table<Mp50> gram(constraints, constraints), right(constraints, 1);
  for (std::size_t c = 0; c < constraints; ++c)
    for (std::size_t k = 0; k < n; ++k) {
      right(c, 0) += of_images(c, k) * gradient[k];
      for (std::size_t b = 0; b < constraints; ++b) gram(c, b) += of_images(c, k) * of_images(b, k);
    }
  const Table<Mp50> multipliers = eliminated(gram, right);
  Mp50 whole = 0, left = 0;
  for (std::size_t k = 0; k < n; ++k) {
    Mp50 along = gradient[k];
    for (std::size_t c = 0; c < constraints; ++c) along -= of_images(c, k) * multipliers(c, 0);
    whole += gradient[k] * gradient[k];
    left += along * along;
  }
  return static_cast<double>(Mp50(sqrt(Mp50(left / whole))));
}

}  // namespace cageproof::second_routes
