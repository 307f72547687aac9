// SPDX-License-Identifier: MIT
#include "layer_route.h"

#include <algorithm>

namespace cageproof::second_routes {
namespace {

Table<Wide> rows_of_vertices(const std::vector<Vec3<double>>& vertices, int dimension) {
  Table<Wide> rows(vertices.size(), static_cast<std::size_t>(dimension));
  for (std::size_t v = 0; v < rows.rows; ++v)
    for (std::size_t c = 0; c < rows.columns; ++c) rows(v, c) = vertices[v][static_cast<Eigen::Index>(c)];
  return rows;
}

// The sum and the product of the squared singular values of an element's map, by the quadratic forms of its edges: the
// trace and the determinant of the posed form over the rest one.
Wide length_of_normal(NormalLength length, const CageElements& elements, const std::vector<Vec3<double>>& posed,
                      std::size_t element) {
  if (length == NormalLength::Unit) return Wide(1);
  const auto corners = elements.vertices_of(element);
  const auto edge = [&](const std::vector<Vec3<double>>& of, std::size_t k) {
    return Vec3<Wide>(convert<Wide>(of[corners[k]]) - convert<Wide>(of[corners[0]]));
  };
  const auto form = [&](const std::vector<Vec3<double>>& of) {
    const Vec3<Wide> u = edge(of, 1), v = corners.size() == 3 ? edge(of, 2) : Vec3<Wide>::Zero();
    return std::array<Wide, 3>{u.dot(u), u.dot(v), v.dot(v)};
  };
  const auto [a, b, c] = form(elements.vertices());
  const auto [e, f, g] = form(posed);
  if (corners.size() == 2) return sqrt(Wide(e / a));
  const Wide determinant = a * c - b * b, sum = (c * e - 2 * b * f + a * g) / determinant,
             root = sqrt(Wide((e * g - f * f) / determinant));
  if (length == NormalLength::Rms) return sqrt(Wide(sum / 2));
  if (length == NormalLength::Mean) return sqrt(Wide(sum + 2 * root)) / 2;
  return sqrt(root);
}

}  // namespace

LayerRoute::LayerRoute(const CageCoordinates& layers, const LayerMethod& method, const std::vector<Vec3<double>>& posed)
    : layers_(layers), vertices_(rows_of_vertices(posed, layers.dimension())), normals_(0, 0), densities_(0, 0) {
  const CageElements& elements = layers.elements();
  normals_ = Table<Wide>(elements.count(), vertices_.columns);
  for (std::size_t j = 0; j < normals_.rows; ++j) {
    const Vec3<Wide> normal = length_of_normal(method.length, elements, posed, j) * unit_normal_of(elements, posed, j);
    for (std::size_t c = 0; c < vertices_.columns; ++c) normals_(j, c) = normal[static_cast<Eigen::Index>(c)];
  }
  const Table<Wide> by_data = densities_by_data(layers, method.densities);
  if (method.alignment)
    normals_ = aligned_normals(layers, by_data, *method.alignment, vertices_, Table<Wide>(normals_));
  Table<Wide> data(by_data.columns, vertices_.columns);
  std::ranges::copy(vertices_.entries, data.entries.begin());
  std::ranges::copy(normals_.entries, data.entries.begin() + static_cast<std::ptrdiff_t>(vertices_.entries.size()));
  densities_ = product(by_data, data);
}

Vec3<Wide> LayerRoute::image_of(const Vec3<double>& point) const {
  std::vector<std::vector<Wide>> of;
  for (const Result<Mp50>& block : layers_.at<Mp50>(convert<Mp50>(point), 0))
    of.emplace_back(block.value.begin(), block.value.end());
  const std::size_t n = vertices_.rows, m = normals_.rows;
  Vec3<Wide> image = Vec3<Wide>::Zero();
  for (std::size_t c = 0; c < vertices_.columns; ++c) {
    Wide& sum = image[static_cast<Eigen::Index>(c)];
    for (std::size_t i = 0; i < n; ++i) sum += of[0][i] * vertices_(i, c) + of[2][i] * densities_(i, c);
    for (std::size_t j = 0; j < m; ++j) sum += of[1][j] * normals_(j, c) + of[3][j] * densities_(n + j, c);
  }
  return image;
}

}  // namespace cageproof::second_routes
