// SPDX-License-Identifier: MIT
#include "elastic_route.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>

namespace cageproof::second_routes {
namespace {

constexpr int parts_of_an_edge = 4;

Evaluation recommended(std::string_view formula) {
  return EvaluationRegister::instance().with_role(formula, Role::Recommended).value();
}

// The shear modulus, which displacements do not depend on, and Poisson's ratio where nobody says another.
std::array<Mp50, 2> elastic_constants() {
  for (const KindParameter& p : parameters_of(coordinate_kind_named("elastic")))
    if (p.name == "nu") return {Mp50(7) / 3, Mp50(p.preset)};
  return {};
}

}  // namespace

ElasticRoute::ElasticRoute(const Cage& cage)
    : cage_(cage),
      displacement_(recommended("segment.kelvin_displacement")),
      traction_(recommended("segment.kelvin_traction")) {
  for (const Vec3<double>& a : cage.vertices())
    for (const Vec3<double>& b : cage.vertices()) unit_ = std::max(unit_, (a - b).stableNorm());
  const Mp50 hair("1e-42");
  std::vector<Vec3<Mp50>> points;
  std::vector<std::array<Mp200, 2>> hats;  // of the ends of the edge that the point is on
  for (std::size_t e = 0; e < cage.faces().size(); ++e)
    for (int half = 0; half < 2 * parts_of_an_edge; ++half) {
      Vec3<Mp50> direction = inward(e);
      for (std::size_t before = 0; half == 0 && before < cage.faces().size(); ++before)
        if (cage.faces()[before].vertices[1] == cage.faces()[e].vertices[0]) direction += inward(before);
      const Mp50 share = Mp50(half) / (2 * parts_of_an_edge);
      points.push_back((1 - share) * vertex(cage.faces()[e].vertices[0]) + share * vertex(cage.faces()[e].vertices[1]) +
                       hair * direction);
      hats.push_back({Mp200(1 - share), Mp200(share)});
    }
  const Layers layers = layers_at(points);
  NormalEquations<Mp200> squares(layers.of_tractions.columns, layers.of_displacements.columns);
  for (std::size_t r = 0; r < layers.of_tractions.rows; ++r) {
    const std::size_t point = r / 2, component = r % 2, edge = point / (2 * parts_of_an_edge);
    for (std::size_t k = 0; k < layers.of_tractions.columns; ++k) squares.row(k) = layers.of_tractions(r, k);
    for (std::size_t c = 0; c < layers.of_displacements.columns; ++c) squares.value(c) = -layers.of_displacements(r, c);
    for (int end = 0; end < 2; ++end)
      squares.value(2 * static_cast<std::size_t>(cage.faces()[edge].vertices[end]) + component) += hats[point][end];
    squares.add();
  }
  tractions_ = squares.solution();
}

Vec3<Mp50> ElasticRoute::vertex(int v) const {
  return (convert<Mp50>(cage_.vertices()[v]) - convert<Mp50>(cage_.vertices()[0])) / Mp50(unit_);
}

Vec3<Mp50> ElasticRoute::node(std::size_t edge, int k) const {
  const Face& face = cage_.faces()[edge];
  return (Mp50(parts_of_an_edge - k) * vertex(face.vertices[0]) + Mp50(k) * vertex(face.vertices[1])) /
         Mp50(parts_of_an_edge);
}

// The cage lies on the left of its edges.
Vec3<Mp50> ElasticRoute::inward(std::size_t edge) const {
  const Vec3<Mp50> along = node(edge, parts_of_an_edge) - node(edge, 0);
  const Vec3<Mp50> left(-along[1], along[0], Mp50(0));
  return left / Mp50(sqrt(Mp50(left.dot(left))));
}

ElasticRoute::Layers ElasticRoute::layers_at(const std::vector<Vec3<Mp50>>& points) const {
  static const std::array<Mp50, 2> constants = elastic_constants();
  const std::size_t edges = cage_.faces().size();
  Layers layers{Matrix(2 * points.size(), 2 * cage_.vertices().size()),
                Matrix(2 * points.size(), 2 * parts_of_an_edge * edges)};
  Result<Mp50> of;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t e = 0; e < edges; ++e)
      for (int k = 0; k < parts_of_an_edge; ++k) {
        const std::array<Vec3<Mp50>, 2> ends{node(e, k), node(e, k + 1)};
        const Query<Mp50> query{ends, points[p], 0, constants};
        displacement_(query, of);
        const std::size_t piece = e * parts_of_an_edge + static_cast<std::size_t>(k);
        for (std::size_t i = 0; i < 4; ++i) layers.of_tractions(2 * p + i / 2, 2 * piece + i % 2) = Mp200(of.value[i]);
        traction_(query, of);
        for (int end = 0; end < 2; ++end)
          for (std::size_t i = 0; i < 4; ++i) {
            const Mp200 entry(of.value[4 * end + i]), share = Mp200(k + end) / parts_of_an_edge;
            const auto& vertices = cage_.faces()[e].vertices;
            layers.of_displacements(2 * p + i / 2, 2 * vertices[0] + i % 2) += (1 - share) * entry;
            layers.of_displacements(2 * p + i / 2, 2 * vertices[1] + i % 2) += share * entry;
          }
      }
  return layers;
}

std::vector<Mp200> ElasticRoute::at(const Vec3<double>& point) const {
  const Vec3<Mp50> in_frame = (convert<Mp50>(point) - convert<Mp50>(cage_.vertices()[0])) / Mp50(unit_);
  const Layers layers = layers_at({in_frame});
  const Matrix solved = product(layers.of_tractions, tractions_);
  std::vector<Mp200> found;
  for (std::size_t v = 0; v < cage_.vertices().size(); ++v)
    for (std::size_t i = 0; i < 4; ++i)
      found.push_back(layers.of_displacements(i / 2, 2 * v + i % 2) + solved(i / 2, 2 * v + i % 2));
  return found;
}

}  // namespace cageproof::second_routes
