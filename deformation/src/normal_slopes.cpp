// SPDX-License-Identifier: MIT
#include "normal_slopes.h"

#include "stretch_slopes.h"
#include "unit_edges.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::deformation {
namespace {

// d(s n')/d(edges), in the users' unit.
template <Scalar R>
std::array<Mat3<R>, 2> triangle_slopes(Stretch stretch, const CageElements& elements, const UnitEdges<R>& rest,
                                       const UnitEdges<R>& posed, std::size_t element) {
  using std::sqrt;
  const Vec3<R> across = posed.edges[0].cross(posed.edges[1]), rest_across = rest.edges[0].cross(rest.edges[1]);
  if (!(R(across.dot(across)) > 0)) refuse_slope(elements, element);
  const R area = sqrt(R(rest_across.dot(rest_across)));
  const BySides<R> turned = area_slopes(posed.edges);
  const Vec3<R> normal = across / turned.value;
  std::array<Mat3<R>, 2> found = unit_normal_slopes(posed.edges);
  if (stretch == Stretch::Unit) {
    for (Mat3<R>& slope : found) slope /= posed.unit;
    return found;
  }
  const BySides<R> stretched = stretched_area_slopes(stretch, rest.edges, posed.edges, area, turned);
  // A product of two stretches has two units of length over those of rest, another one.
  const R unit = stretch == Stretch::Product ? R(posed.unit / rest.unit / rest.unit) : R(1 / rest.unit);
  for (int k = 0; k < 2; ++k)
    found[k] = (stretched.value / area * found[k] + normal * (stretched.slopes[k] / area).transpose()) * unit;
  return found;
}

template <Scalar R>
void add_triangle(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
                  std::size_t row, RowSlopes<R>& slopes) {
  const auto corners = rest.vertices_of(element);
  const int corner = widest_corner(rest, element);
  const UnitEdges<R> from(rest, rest.vertices(), element, corner), to(rest, vertices, element, corner);
  std::array<Mat3<R>, 2> found;
  bool is_found = false;
  // Edges in line by 1e-3 and less cancel.
  if constexpr (std::same_as<R, double>)
    if (from.edges[0].cross(from.edges[1]).norm() <= 1e-3 * from.edges[0].norm() * from.edges[1].norm()) {
      const UnitEdges<Mp50> wide(rest, rest.vertices(), element, corner), posed(rest, vertices, element, corner);
      const std::array<Mat3<Mp50>, 2> exact = triangle_slopes<Mp50>(stretch, rest, wide, posed, element);
      for (int k = 0; k < 2; ++k) found[k] = exact[k].template cast<double>();
      is_found = true;
    }
  if (!is_found) found = triangle_slopes<R>(stretch, rest, from, to, element);
  slopes.parts.push_back({row, corners[(corner + 1) % 3], found[0]});
  slopes.parts.push_back({row, corners[(corner + 2) % 3], found[1]});
  slopes.parts.push_back({row, corners[corner], Mat3<R>(-found[0] - found[1])});
}

// In the plane the posed edge turned by a quarter, over its own length or, with all stretches except Unit, the rest's.
template <Scalar R>
void add_segment(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
                 RowSlopes<R>& slopes) {
  using std::sqrt;
  const auto corners = rest.vertices_of(element);
  const auto length = [](const Vec3<R>& edge) -> R {
    const R largest = edge.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return largest;
    const Vec3<R> scaled = edge / largest;
    return largest * R(sqrt(R(scaled.dot(scaled))));
  };
  Mat3<R> quarter = Mat3<R>::Zero();
  quarter(0, 1) = 1;
  quarter(1, 0) = -1;
  Mat3<R> slope;
  if (stretch == Stretch::Unit) {
    const Vec3<R> edge = vertices[corners[1]] - vertices[corners[0]];
    const R own = length(edge);
    if (!(own > 0)) refuse_slope(rest, element);
    const Vec3<R> along = edge / own;
    slope = quarter * (Mat3<R>::Identity() - along * along.transpose()) / own;
  } else {
    slope = quarter / length(convert<R>(rest.vertices()[corners[1]]) - convert<R>(rest.vertices()[corners[0]]));
  }
  slopes.parts.push_back({element, corners[1], slope});
  slopes.parts.push_back({element, corners[0], Mat3<R>(-slope)});
}

}  // namespace

void refuse_slope(const CageElements& rest, std::size_t element) {
  throw InputError(fmt::format("the posed {} {} (vertices {}) has no {}, and its normal no derivative",
                               rest.type(element).name, element, fmt::join(rest.vertices_of(element), ", "),
                               rest.dimension() == 2 ? "length" : "area"));
}

template <Scalar R>
RowSlopes<R> stretched_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices) {
  RowSlopes<R> slopes{.rows = rest.count(Owner::Normal)};
  std::size_t row = 0;
  for (std::size_t e = 0; e < rest.count(); ++e) {
    if (rest.dimension() == 2) add_segment(stretch, rest, vertices, e, slopes);
    else if (rest.type(e).flat) add_triangle(stretch, rest, vertices, e, row, slopes);
    else add_quad_normal_slopes(stretch, rest, vertices, e, row, slopes);
    row += rest.shares_of(e, Owner::Normal).size();
  }
  return slopes;
}

template RowSlopes<double> stretched_normal_slopes<double>(Stretch, const CageElements&,
                                                           const std::vector<Vec3<double>>&);
template RowSlopes<Mp50> stretched_normal_slopes<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&);

}  // namespace cageproof::deformation
