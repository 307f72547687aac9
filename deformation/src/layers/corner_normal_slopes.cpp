// SPDX-License-Identifier: MIT
#include "../normal_slopes.h"
#include "../own_unit.h"
#include "../stretch_slopes.h"
#include "../turn_slopes.h"
#include "../unit_edges.h"

#include <array>

namespace cageproof::deformation {
namespace {

// The gradient of an element's stretch by each of its corners, in the users' unit.
template <Scalar R>
std::array<Vec3<R>, 3> stretch_gradients(Stretch stretch, const CageElements& rest,
                                         const std::vector<Vec3<R>>& vertices, std::size_t element) {
  using std::sqrt;
  std::array<Vec3<R>, 3> found;
  found.fill(Vec3<R>::Zero());
  if (stretch == Stretch::Unit) return found;
  if (rest.dimension() == 2) {
    const Vec3<R> posed = tangents_of(rest, vertices, element)[0];
    const Vec3<R> from = tangents_of(rest, vertices_in<R>(rest), element)[0];
    const R length = sqrt(R(posed.dot(posed)));
    if (!(length > 0)) refuse_slope(rest, element);
    found[1] = posed / length / R(sqrt(R(from.dot(from))));
    found[0] = -found[1];
    return found;
  }
  const int corner = widest_corner(rest, element);
  const UnitEdges<R> from(rest, rest.vertices(), element, corner), to(rest, vertices, element, corner);
  const Vec3<R> across = from.edges[0].cross(from.edges[1]);
  const R area = sqrt(R(across.dot(across)));
  const BySides<R> by = stretched_area_slopes(stretch, from.edges, to.edges, area, area_slopes(to.edges));
  for (int k = 0; k < 2; ++k) {
    found[(corner + 1 + k) % 3] = by.slopes[k] / (area * from.unit);
    found[corner] -= found[(corner + 1 + k) % 3];
  }
  if (!found[corner].allFinite()) refuse_slope(rest, element);
  return found;
}

}  // namespace

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
    const std::array<Vec3<R>, 3> gradients = stretch_gradients(stretch, rest, vertices, e);
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
