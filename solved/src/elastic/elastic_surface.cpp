// SPDX-License-Identifier: MIT
#include "elastic_surface.h"

namespace cageproof::solved {

ElasticSurface::ElasticSurface(const Cage& cage, const CageElements& elements, int level)
    : pieces(cage, elements, level, densities), whole(cage, elements, 0, 1) {}

std::vector<PlaceOnTriangle> centroids(const RefinedSurface& surface) {
  constexpr double third = 1. / 3;
  std::vector<PlaceOnTriangle> places;
  for (int t = 0; t < surface.triangles(); ++t)
    for (int k = 0; k < surface.pieces_a_triangle(); ++k) places.push_back(surface.place(t, k, third, third));
  return places;
}

template <Scalar R>
ElasticSurfaceLayers<R>::ElasticSurfaceLayers(const ElasticSurface& surface, const ElasticEvaluations& evaluations,
                                              double nu, int vertices)
    : surface_(surface),
      displacement_(surface.pieces, evaluations.displacement, std::array{R(1), R(nu)}),
      traction_(surface.whole, evaluations.traction, std::array{R(1), R(nu)}),
      vertices_(static_cast<std::size_t>(vertices)) {}

template <Scalar R>
CoordinateTable<R> ElasticSurfaceLayers<R>::traction_limit(const PlaceOnTriangle& place, int order) const {
  const Touching on = place.touching();
  CoordinateTable<R> corners = traction_.table(1, order), found;
  traction_.add_on(RefinedSurface::at<R>(surface_.whole.corners_of<R>(place.triangle), place.second, place.third),
                   std::span(&on, 1), order, corners);
  for (int o = 0; o <= order; ++o) {
    const std::size_t width = 9 * derivative_count(3, o);
    found.stride[o] = vertices_ * width;
    found.tensors[o].assign(found.stride[o], R(0));
    const R* from = corners.tensors[o].data();
    for (int t = 0; t < surface_.whole.triangles(); ++t)
      for (const int vertex : surface_.whole.vertices_of(t)) {
        R* const to = &found.tensors[o][static_cast<std::size_t>(vertex) * width];
        for (std::size_t k = 0; k < width; ++k) to[k] += *from++;
      }
  }
  return found;
}

template class ElasticSurfaceLayers<double>;
template class ElasticSurfaceLayers<Mp50>;
template class ElasticSurfaceLayers<Mp100>;

}  // namespace cageproof::solved
