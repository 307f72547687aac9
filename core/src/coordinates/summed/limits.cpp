// SPDX-License-Identifier: MIT
#include "limits.h"

#include "element_axes.h"

#include <algorithm>

namespace cageproof {
namespace {

template <Scalar R>
Vec3<R> first_corner_in(const Summands& sum, std::size_t e) {
  return convert<R>(sum.elements->vertices()[sum.elements->vertices_of(e)[0]]);
}

template <Scalar R>
std::vector<Vec3<R>> corners_in(const Summands& sum, std::size_t e, const Vec3<R>& origin) {
  std::vector<Vec3<R>> corners;
  corners.reserve(4);
  for (const int v : sum.elements->vertices_of(e)) corners.push_back(convert<R>(sum.elements->vertices()[v]) - origin);
  return corners;
}

// A bilinear quad has no plane to see the point in: it is seen in more digits, from so near inside that the limit is
// as good as R. Others see the point from the quad's first corner.
template <Scalar R>
void put_limit_on_quad(const Summands& sum, const Touching& place, std::size_t p, int order,
                       std::span<CoordinateTable<R>> tables) {
  constexpr bool is_wide = is_multiprecision<R>;
  using W = std::conditional_t<is_wide, Mp100, Mp50>;
  const Vec3<R> origin = first_corner_in<R>(sum, place.element);
  const std::vector<Vec3<W>> quad = corners_in<W>(sum, place.element, first_corner_in<W>(sum, place.element));
  const W u = W(place.basis[1]) + W(place.basis[2]), v = W(place.basis[2]) + W(place.basis[3]);
  const Vec3<W> along_u = (1 - v) * (quad[1] - quad[0]) + v * (quad[2] - quad[3]),
                along_v = (1 - u) * (quad[3] - quad[0]) + u * (quad[2] - quad[1]);
  const Vec3<W> on = (1 - u) * quad[0] + u * quad[1] + v * along_v, normal = along_u.cross(along_v);
  const W size = sqrt(W(along_u.dot(along_u) + along_v.dot(along_v))), area = sqrt(W(normal.dot(normal)));
  const Vec3<W> inside = on - (size * W(is_wide ? "1e-40" : "1e-25") / area) * normal;
  const Vec3<R> rounded = convert<R>(on);
  const std::vector<R> parameters(sum.parameters.begin(), sum.parameters.end());
  const std::vector<W> wide_parameters(sum.parameters.begin(), sum.parameters.end());
  Result<R> part;
  Result<W> wide;
  for (std::size_t e = 0; e < sum.elements->count(); ++e) {
    const bool own = static_cast<int>(e) == place.element;
    for (std::size_t b = 0; b < sum.blocks.size(); ++b) {
      const Evaluation& evaluation = sum.evaluations[static_cast<std::size_t>(sum.elements->type(e).kind)][b];
      BatchOutput<R> here = sum.output_for(b, p, tables[b]);
      here.slots = sum.elements->shares_of(e, sum.blocks[b].owner);
      if (own) evaluation(Query<W>{quad, inside, order, wide_parameters}, wide);
      else evaluation(Query<R>{corners_in<R>(sum, e, origin), rounded, order, parameters}, part);
      for (int o = 0; o <= order; ++o) {
        if (own) {
          part.of(o).resize(wide.of(o).size());
          std::ranges::transform(wide.of(o), part.of(o).begin(), [](const W& x) { return static_cast<R>(x); });
        }
        here.put(0, o, part.of(o));
      }
    }
  }
}

// The origin is moved to the element's first corner. The point's rounding is then relative to the element's size,
// however far the origin is and however small the element is. A point on its own element is also put into that
// element's plane, where its height is exactly zero.
template <Scalar R>
void put_limit(const Summands& sum, const Touching& place, std::size_t p, int order,
               std::span<CoordinateTable<R>> tables) {
  if (!sum.elements->type(place.element).flat) return put_limit_on_quad(sum, place, p, order, tables);
  const Vec3<R> origin = first_corner_in<R>(sum, place.element);
  const ElementAxes<R> axes(corners_in<R>(sum, place.element, origin));
  const std::vector<Vec3<R>>& flat = axes.corners();
  Vec3<R> in_plane = Vec3<R>::Zero();
  for (std::size_t k = 1; k < flat.size(); ++k) in_plane += R(place.basis[k]) * flat[k];
  const Vec3<R> point = axes.in_space(in_plane);
  const std::vector<R> parameters(sum.parameters.begin(), sum.parameters.end());
  Result<R> part;
  for (std::size_t e = 0; e < sum.elements->count(); ++e) {
    const bool own = static_cast<int>(e) == place.element;
    const std::vector<Vec3<R>> corners = own ? flat : corners_in<R>(sum, e, origin);
    for (std::size_t b = 0; b < sum.blocks.size(); ++b) {
      sum.evaluations[static_cast<std::size_t>(sum.elements->type(e).kind)][b](
          Query<R>{corners, own ? in_plane : point, order, parameters}, part);
      if (own) axes.turn_to_space(order, part);
      BatchOutput<R> here = sum.output_for(b, p, tables[b]);
      here.slots = sum.elements->shares_of(e, sum.blocks[b].owner);
      for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
    }
  }
}

template <Scalar R>
void put(const Summands& sum, std::span<const Touching> places, int order, std::span<CoordinateTable<R>> tables) {
  for (std::size_t p = 0; p < places.size(); ++p) put_limit<R>(sum, places[p], p, order, tables);
  sum.times_area_elements(places.size(), order, tables);
}

}  // namespace

void put_limits(const Summands& sum, std::span<const Touching> places, int order,
                std::span<CoordinateTable<double>> tables) {
  put<double>(sum, places, order, tables);
}
void put_limits(const Summands& sum, std::span<const Touching> places, int order,
                std::span<CoordinateTable<Mp50>> tables) {
  put<Mp50>(sum, places, order, tables);
}

}  // namespace cageproof
