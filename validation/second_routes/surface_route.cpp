// SPDX-License-Identifier: MIT
#include "surface_route.h"

#include "cageproof/core/numbers/linear.h"

namespace cageproof::second_routes {
namespace {

Evaluation recommended_layer(std::string_view formula) {
  return EvaluationRegister::instance().with_role(formula, Role::Recommended).value();
}

}  // namespace

SurfaceRoute::SurfaceRoute(const Cage& cage)
    : vertices_(cage.vertices().size()),
      double_layer_(recommended_layer("triangle.double_layer")),
      single_layer_(recommended_layer("triangle.affine_single_layer")),
      slopes_(0, 0) {
  const Cage::Parts parts = cage.parts(false, Triangulation::Shortest);
  for (const Face& face : parts.elements) {
    const std::array<int, 3>& v =
        numbers_.emplace_back(std::array{face.vertices[0], face.vertices[1], face.vertices[2]});
    Corners& c = triangles_.emplace_back();
    for (int k = 0; k < 3; ++k) c[k] = convert<Mp50>(cage.vertices()[v[k]]);
    const auto middle = [&](int i, int j) { return Vec3<Mp50>((c[i] + c[j]) / Mp50(2)); };
    const Vec3<Mp50> ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    for (const Corners& quarter :
         {Corners{ab, bc, ca}, Corners{c[0], ab, ca}, Corners{ab, c[1], bc}, Corners{ca, bc, c[2]}})
      quarters_.push_back(quarter);
  }
  // So far inside of the places, in cage sizes: layers are Hoelder continuous there.
  const Mp50 hair = Mp50("1e-42") * Mp50(cage.size());
  const std::size_t unknowns = 3 * quarters_.size();
  Table<Mp200> matrix(unknowns, unknowns), right(unknowns, vertices_);
  std::size_t row = 0;
  for (std::size_t q = 0; q < quarters_.size(); ++q) {
    const Corners& whole = triangles_[q / 4];
    const Vec3<Mp50> first = whole[1] - whole[0], second = whole[2] - whole[0], across = first.cross(second);
    const Mp50 area(sqrt(Mp50(across.dot(across))));
    for (int near = 0; near < 3; ++near, ++row) {
      Vec3<Mp50> place = Vec3<Mp50>::Zero();
      for (int k = 0; k < 3; ++k) place += Mp50(k == near ? 10 : 3) / Mp50(16) * quarters_[q][k];
      const Layers layers = layers_at(place - hair / area * across);
      for (std::size_t k = 0; k < unknowns; ++k) matrix(row, k) = layers.psi[k];
      for (std::size_t v = 0; v < vertices_; ++v) right(row, v) = -layers.phi[v];
      // Hat functions as shares of the triangle's area.
      for (int k = 0; k < 3; ++k) {
        const Vec3<Mp50> part = (whole[(k + 1) % 3] - place).cross(whole[(k + 2) % 3] - place);
        right(row, numbers_[q / 4][k]) += Mp200(Mp50(part.dot(across) / (area * area)));
      }
    }
  }
  slopes_ = eliminated(std::move(matrix), std::move(right));
}

SurfaceRoute::Layers SurfaceRoute::layers_at(const Vec3<Mp50>& point) const {
  Layers found{std::vector<Mp200>(vertices_, Mp200(0)), {}};
  Result<Mp50> layer;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    double_layer_(Query<Mp50>{triangles_[t], point}, layer);
    for (int k = 0; k < 3; ++k) found.phi[numbers_[t][k]] += Mp200(layer.value[k]);
  }
  for (const Corners& quarter : quarters_) {
    single_layer_(Query<Mp50>{quarter, point}, layer);
    for (const Mp50& x : layer.value) found.psi.emplace_back(x);
  }
  return found;
}

std::vector<Mp200> SurfaceRoute::at(const Vec3<double>& point) const {
  Layers layers = layers_at(convert<Mp50>(point));
  for (std::size_t k = 0; k < layers.psi.size(); ++k)
    for (std::size_t v = 0; v < vertices_; ++v) layers.phi[v] += layers.psi[k] * slopes_(k, v);
  return layers.phi;
}

}  // namespace cageproof::second_routes
