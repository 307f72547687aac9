// SPDX-License-Identifier: MIT
#include "elastic_surface_route.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/numbers/linear.h"

namespace cageproof::second_routes {
namespace {

Evaluation recommended_of_triangles(std::string_view formula) {
  return EvaluationRegister::instance().with_role(formula, Role::Recommended).value();
}

double preset_of_nu() {
  for (const KindParameter& p : parameters_of(coordinate_kind_named("elastic")))
    if (p.name == "nu") return p.preset;
  return 0;
}

}  // namespace

ElasticSurfaceRoute::ElasticSurfaceRoute(const Cage& cage)
    : vertices_(cage.vertices().size()),
      displacement_(recommended_of_triangles("triangle.kelvin_displacement")),
      traction_(recommended_of_triangles("triangle.kelvin_traction")),
      constants_{Mp50(7) / 3, Mp50(preset_of_nu())},  // displacements do not depend on the first
      tractions_(0, 0) {
  for (const Face& face : cage.parts(false, Triangulation::Shortest).elements) {
    const std::array<int, 3>& v =
        numbers_.emplace_back(std::array{face.vertices[0], face.vertices[1], face.vertices[2]});
    Corners& c = triangles_.emplace_back();
    for (int k = 0; k < 3; ++k) c[k] = convert<Mp50>(cage.vertices()[v[k]]);
    const auto middle = [&](int i, int j) { return Vec3<Mp50>((c[i] + c[j]) / Mp50(2)); };
    const Vec3<Mp50> ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    for (const Corners& quarter :
         {Corners{bc, ca, ab}, Corners{c[0], ab, ca}, Corners{ab, c[1], bc}, Corners{ca, bc, c[2]}})
      quarters_.push_back(quarter);
  }
  // So far inside of the places, in cage sizes: layers are Hoelder continuous there.
  const Mp50 hair = Mp50("1e-42") * Mp50(cage.size());
  // The quarters' centroids as the scheme has them: basis functions of a triangle's second and third corner, in double.
  constexpr double sixth = 1. / 3 / 2;
  constexpr std::array<std::array<double, 2>, 4> centroids{
      {{0.5 - sixth, 0.5 - sixth}, {sixth, sixth}, {0.5 + sixth, sixth}, {sixth, 0.5 + sixth}}};
  const std::size_t unknowns = 3 * quarters_.size(), columns = 3 * vertices_;
  Rows matrix(unknowns, unknowns), right(unknowns, columns);
  for (std::size_t q = 0; q < quarters_.size(); ++q) {
    const Corners& whole = triangles_[q / 4];
    const Vec3<Mp50> across = (whole[1] - whole[0]).cross(whole[2] - whole[0]);
    const Mp50 area(sqrt(Mp50(across.dot(across))));
    const Mp50 second(centroids[q % 4][0]), third(centroids[q % 4][1]);
    const Vec3<Mp50> place = whole[0] + second * (whole[1] - whole[0]) + third * (whole[2] - whole[0]);
    const Layers layers = layers_at(place - hair / area * across);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < unknowns; ++k) matrix(3 * q + i, k) = layers.of_tractions(i, k);
      for (std::size_t c = 0; c < columns; ++c) right(3 * q + i, c) = -layers.of_displacements(i, c);
      // Hat functions as shares of the triangle's area.
      for (int k = 0; k < 3; ++k) {
        const Vec3<Mp50> part = (whole[(k + 1) % 3] - place).cross(whole[(k + 2) % 3] - place);
        right(3 * q + i, 3 * static_cast<std::size_t>(numbers_[q / 4][k]) + i) +=
            Mp200(Mp50(part.dot(across) / (area * area)));
      }
    }
  }
  tractions_ = eliminated(std::move(matrix), std::move(right));
}

ElasticSurfaceRoute::Layers ElasticSurfaceRoute::layers_at(const Vec3<Mp50>& point) const {
  Layers found{Rows(3, 3 * vertices_), Rows(3, 3 * quarters_.size())};
  Result<Mp50> layer;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    traction_(Query<Mp50>{triangles_[t], point, 0, constants_}, layer);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 9; ++i)
        found.of_displacements(i / 3, 3 * static_cast<std::size_t>(numbers_[t][k]) + i % 3) +=
            Mp200(layer.value[9 * k + i]);
  }
  for (std::size_t q = 0; q < quarters_.size(); ++q) {
    displacement_(Query<Mp50>{quarters_[q], point, 0, constants_}, layer);
    for (std::size_t i = 0; i < 9; ++i) found.of_tractions(i / 3, 3 * q + i % 3) = Mp200(layer.value[i]);
  }
  return found;
}

std::vector<Mp200> ElasticSurfaceRoute::at(const Vec3<double>& point) const {
  const Layers layers = layers_at(convert<Mp50>(point));
  const Rows solved = product(layers.of_tractions, tractions_);
  std::vector<Mp200> found;
  for (std::size_t v = 0; v < vertices_; ++v)
    for (std::size_t i = 0; i < 9; ++i)
      found.push_back(layers.of_displacements(i / 3, 3 * v + i % 3) + solved(i / 3, 3 * v + i % 3));
  return found;
}

}  // namespace cageproof::second_routes
