// SPDX-License-Identifier: MIT
#include "stretch_gradients.h"

#include "normal_slopes.h"
#include "rotation_slope.h"
#include "stretch_slopes.h"
#include "unit_edges.h"

#include <algorithm>

namespace cageproof::deformation {
namespace {

// Divides tangents by their largest number, and returns it.
template <Scalar R>
R unit_out_of(std::array<Vec3<R>, 2>& tangents) {
  const R unit = std::max<R>(tangents[0].cwiseAbs().maxCoeff(), tangents[1].cwiseAbs().maxCoeff());
  if (unit > 0)
    for (Vec3<R>& tangent : tangents) tangent /= unit;
  return unit;
}

}  // namespace

template <Scalar R>
std::array<Vec3<R>, 4> stretch_gradients(Stretch stretch, const CageElements& rest,
                                         const std::vector<Vec3<R>>& vertices, const NormalPlace& at) {
  using std::sqrt;
  std::array<Vec3<R>, 4> found;
  found.fill(Vec3<R>::Zero());
  if (stretch == Stretch::Unit) return found;
  // Edges of a triangle come from its widest corner, where least cancels.
  const bool is_triangle = rest.dimension() == 3 && rest.type(at.element).flat;
  const int first = is_triangle ? widest_corner(rest, at.element) : 0;
  std::array<Vec3<R>, 2> from, to;
  R unit, posed_unit;
  if (is_triangle) {
    const UnitEdges<R> before(rest, rest.vertices(), at.element, first), after(rest, vertices, at.element, first);
    from = before.edges, to = after.edges, unit = before.unit, posed_unit = after.unit;
  } else {
    from = tangents_of(rest, vertices_in<R>(rest), at.element, at.corner);
    to = tangents_of(rest, vertices, at.element, at.corner);
    if (rest.dimension() == 2) from[1] = to[1] = Vec3<R>::Zero();
    unit = unit_out_of(from), posed_unit = unit_out_of(to);
  }
  BySides<R> by;
  R area;
  if (rest.dimension() == 2) {
    const R length = sqrt(R(to[0].dot(to[0])));
    area = sqrt(R(from[0].dot(from[0])));
    if (!(posed_unit > 0)) refuse_slope(rest, at.element);
    by.slopes[0] = to[0] / length;
  } else {
    const Vec3<R> across = from[0].cross(from[1]);
    area = sqrt(R(across.dot(across)));
    by = stretched_area_slopes(stretch, from, to, area, area_slopes(to));
  }
  const R over = area * unit * (stretch == Stretch::Product ? R(unit / posed_unit) : R(1));
  const std::size_t corners = rest.vertices_of(at.element).size();
  const auto weights = tangent_weights<R>(corners, at.corner);
  for (std::size_t k = 0; k < corners; ++k) {
    Vec3<R>& gradient = found[(k + static_cast<std::size_t>(first)) % corners];
    gradient = (weights[k][0] * by.slopes[0] + weights[k][1] * by.slopes[1]) / over;
    if (!gradient.allFinite()) refuse_slope(rest, at.element);
  }
  return found;
}

template std::array<Vec3<double>, 4> stretch_gradients<double>(Stretch, const CageElements&,
                                                               const std::vector<Vec3<double>>&, const NormalPlace&);
template std::array<Vec3<Mp50>, 4> stretch_gradients<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&,
                                                           const NormalPlace&);

}  // namespace cageproof::deformation
