// SPDX-License-Identifier: MIT
#include "../normal_slopes.h"
#include "../own_unit.h"
#include "../stretch_gradients.h"
#include "../turn_slopes.h"

namespace cageproof::deformation {
// n = s Q_v n_0, so that dn = Q_v n_0 ds + theta_v x n.
template <Scalar R>
RowSlopes<R> corner_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices) {
  const R unit(unit_next_to(size_of(rest)));
  const std::vector<Vec3<R>> from = over(vertices_in<R>(rest), unit);
  const TurnSlopes<R> turns = vertex_turn_slopes(rest, from, normal_turn_slopes(rest, from, over(vertices, unit)));
  std::vector<std::vector<std::size_t>> parts_of(vertices.size());
  for (std::size_t i = 0; i < turns.slopes.parts.size(); ++i) parts_of[turns.slopes.parts[i].row].push_back(i);
  RowSlopes<R> slopes{.rows = rest.count(Owner::Corner)};
  std::size_t row = 0;
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const R factor = stretch_of(stretch, rest, vertices, e);
    const Vec3<R> normal = posed_normal(rest, from, e);
    const std::array<Vec3<R>, 4> gradients = stretch_gradients(stretch, rest, vertices, {e, 0});
    const auto corners = rest.vertices_of(e);
    for (const int v : corners) {
      const Vec3<R> turned = turns.rotations[v] * normal;
      for (std::size_t k = 0; k < corners.size(); ++k)
        slopes.parts.push_back({row, corners[k], Mat3<R>(turned * gradients[k].transpose())});
      const Mat3<R> by_turn = cross_matrix(turned) * R(-factor / unit);
      for (const std::size_t i : parts_of[v]) {
        const auto& part = turns.slopes.parts[i];
        slopes.parts.push_back({row, part.vertex, Mat3<R>(by_turn * part.slope)});
      }
      ++row;
    }
  }
  return slopes;
}

template RowSlopes<double> corner_normal_slopes<double>(Stretch, const CageElements&, const std::vector<Vec3<double>>&);
template RowSlopes<Mp50> corner_normal_slopes<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&);

}  // namespace cageproof::deformation
