// SPDX-License-Identifier: MIT
// Biharmonic coordinates of polygons ([W12] Section 4, after the errata).
#include "../boundary/boundary_coordinates.h"
#include "../boundary/boundary_parameters.h"

#include "../boundary/least_squares.h"

namespace cageproof::solved {
namespace {

struct BiharmonicScheme {
  static constexpr std::string_view label = "alpha";
  static constexpr int order = 2;
  static constexpr std::array unknown{Layer::BiharmonicDouble, Layer::BiharmonicSingle};

  /// l = B f + C d and k = A l of Eq 17-19, with hat functions at the collocation points in place of I.
  template <Scalar R>
  static Densities<R> solve(const RefinedPolygon& polygon, const BoundaryLayers<R>& layers,
                            const std::vector<double>& parameters, double inset, bool described) {
    const Collocation& where = collocations()[static_cast<std::size_t>(parameters[1])];
    const LayerRows<R> laplacian = layers.rows(points_on(polygon, where.of_laplacians), inset);
    const LayerRows<R> value = layers.rows(points_on(polygon, where.of_value), inset);
    const LeastSquares<R> first(laplacian[Layer::Single]);
    const Matrix<R> right = laplacian.hats - laplacian[Layer::Double];
    const Matrix<R> a = first.solve(right);
    const Matrix<R> k = value[Layer::BiharmonicDouble] + value[Layer::BiharmonicSingle] * a;
    Matrix<R> data(k.rows(), polygon.vertices() + polygon.edges());
    data << (value.hats - value[Layer::Double]) * nodes_from_vertices<R>(polygon),
        -value[Layer::Single] * pieces_from_edges<R>(polygon);
    const LeastSquares<R> second(k);
    Densities<R> found{second.inverse() * data, {{0, 0, {}}, {1, 0, a}}, {}};
    if constexpr (std::same_as<R, double>)
      if (described)
        found.systems = {
            describe("Eq 14, the Laplacian's normal derivative from the Laplacian", laplacian[Layer::Single],
                     first.rank(), right, a),
            describe("Eq 13, the Laplacian from values and normal derivatives", k, second.rank(), data, found.own)};
    return found;
  }
};

std::shared_ptr<const PreparedCoordinates> prepare_biharmonic(const Cage& cage, const CoordinateOptions& options) {
  return std::make_shared<BoundaryCoordinates<BiharmonicScheme>>(cage, options);
}

const RegisterCoordinateKind register_biharmonic_boundary{
    {.name = "biharmonic_boundary",
     .source = "[W12] Section 4, Eq 17-19 after the errata",
     .own_dimension = 2,
     .prepare = prepare_biharmonic,
     .parameters = boundary_parameters(collocations(), "where the boundary's equations are asked to hold"),
     .other_evaluations = {offset_evaluation},
     .approximates = "biharmonic_goursat",
     .meets_boundary_data = true,
     .refuses = why_not_refined}};

}  // namespace
}  // namespace cageproof::solved
