// SPDX-License-Identifier: MIT
// Harmonic coordinates of polygons (Joshi et al. 2007) by boundary elements: the baseline of [W12].
#include "../boundary/boundary_coordinates.h"
#include "../boundary/boundary_parameters.h"

namespace cageproof::solved {
namespace {

struct HarmonicCollocation {
  std::string_view name;
  PiecePoints points;
};

const std::vector<HarmonicCollocation>& harmonic_collocations() {
  static const std::vector<HarmonicCollocation> all{{"vertices", {1, {0}}},
                                                    {"vertices-and-midpoints", {2, {0, 1}}},
                                                    {"quarter-points", {4, {0, 1, 2, 3}}},
                                                    {"midpoints", {2, {1}}}};
  return all;
}

struct HarmonicScheme {
  static constexpr std::string_view label = "lambda";
  static constexpr int order = 1;
  static constexpr std::array unknown{Layer::Single};

  /// The normal derivative of each coordinate, constant on pieces, from Eq 12 for the hat functions' harmonic
  /// extensions: f = phi^H f + psi^H d on the boundary.
  template <Scalar R>
  static Densities<R> solve(const RefinedPolygon& polygon, const BoundaryLayers<R>& layers,
                            const std::vector<double>& parameters, double, bool described) {
    const HarmonicCollocation& where = harmonic_collocations()[static_cast<std::size_t>(parameters[1])];
    const LayerRows<R> rows = layers.rows(points_on(polygon, where.points));
    const LeastSquares<R> system(rows[Layer::Single]);
    const Matrix<R> data = (rows.hats - rows[Layer::Double]) * nodes_from_vertices<R>(polygon);
    Densities<R> found{system.inverse() * data, {{0, 0, {}}}, {}};
    if constexpr (std::same_as<R, double>)
      if (described)
        found.systems = {
            describe("Eq 12, the normal derivative from values", rows[Layer::Single], system.rank(), data, found.own)};
    return found;
  }
};

const RegisterCoordinateKind register_harmonic{
    {.name = "harmonic",
     .source = "Joshi et al. 2007, by the boundary elements of [W12] Section 4.2",
     .own_dimension = 2,
     .prepare = prepare_boundary<HarmonicScheme>,
     .parameters = boundary_parameters(harmonic_collocations(), "where the boundary's equation is asked to hold"),
     .approximates = "harmonic_goursat",
     .meets_boundary_data = true,
     .refuses = why_not_refined}};

}  // namespace
}  // namespace cageproof::solved
