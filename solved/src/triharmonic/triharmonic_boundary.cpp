// SPDX-License-Identifier: MIT
// Polyharmonic coordinates of order 3 of polygons ([W12] Appendix B, after the errata).
#include "../boundary/boundary_coordinates.h"
#include "../boundary/boundary_parameters.h"
#include "../boundary/polyharmonic_equations.h"

#include <algorithm>

namespace cageproof::solved {
namespace {

/// The data are values f and Laplacians m at vertices and normal derivatives d on edges; what they do not determine
/// directly is the Laplacian's normal derivative, and the second Laplacian l with its own. Green's identities of
/// s = 3, 2, 1, on the boundary, with the layers of Appendix B by their order:
///
///     l = phi_1 l + psi_1 A l
///     m = phi_1 m + psi_1 (A m - E l) + K_2 l                with K_s = phi_s + psi_s A
///     f = phi_1 f + psi_1 d + K_2 m + (K_3 - psi_2 E) l
///
/// The last system takes the fourth integral of l, and leaves what pieces do not resolve of it to chance: solved
/// plainly, l grows at corners like a piece's length to the power of -4, and nothing converges. Data that are linear on
/// edges, and slopes that are constant there, fit no smooth function better than to the square of an edge's length; so
/// what l needs to be that large for is held down (Tikhonov), whatever the pieces.
struct TriharmonicScheme {
  static constexpr std::string_view label = "alpha";
  static constexpr int order = 3;
  static constexpr std::array unknown{Layer::BiharmonicDouble, Layer::BiharmonicSingle, Layer::TriharmonicDouble,
                                      Layer::TriharmonicSingle};

  // The square of the longest edge, in diameters, over ten. Among powers of three it is the best, within a factor of
  // three, for known functions in a square, a triangle, a pentagon and an L with 4 to 32 vertices per edge.
  static double share_held_down(const RefinedPolygon& polygon) {
    double longest = 0;
    for (int e = 0; e < polygon.edges(); ++e)
      longest = std::max(longest, polygon.line<double>(e).piece * polygon.pieces_an_edge());
    return longest * longest / 10;
  }

  template <Scalar R>
  static Densities<R> solve(const RefinedPolygon& polygon, const BoundaryLayers<R>& layers,
                            const std::vector<double>& parameters, double inset, bool described) {
    const PolyharmonicEquations<R> equations(polygon, layers, parameters[1], inset);
    const LayerRows<R>&laplacian = equations.laplacian, &value = equations.value;
    const Matrix<R>& a = equations.slopes;
    const Matrix<R> e =
        equations.single.solve(laplacian[Layer::BiharmonicDouble] + laplacian[Layer::BiharmonicSingle] * a);
    const Matrix<R> k3 =
        value[Layer::TriharmonicDouble] + value[Layer::TriharmonicSingle] * a - value[Layer::BiharmonicSingle] * e;
    const Eigen::Index n = k3.cols(), vertices = polygon.vertices();
    Matrix<R> held = Matrix<R>::Zero(k3.rows() + n, n);
    held.topRows(k3.rows()) = k3;
    held.bottomRows(n).diagonal().setConstant(share_held_down(polygon) * k3.norm());
    Matrix<R> data = Matrix<R>::Zero(held.rows(), equations.data.cols() + vertices);
    data.topRows(k3.rows()) << equations.data, -equations.biharmonic * equations.nodes;

    // Laplacians at nodes above, second Laplacians below.
    Densities<R> found;
    found.own = Matrix<R>::Zero(2 * n, data.cols());
    found.own.topRightCorner(n, vertices) = equations.nodes;
    found.own.bottomRows(n) = LeastSquares<R>(held).inverse() * data;
    found.shares = {{0, 0, {}}, {1, 0, a}, {1, n, Matrix<R>(-e)}, {2, n, {}}, {3, n, a}};
    if constexpr (std::same_as<R, double>)
      if (described)
        found.systems = {
            equations.described("s = 3 and 2, normal derivatives of Laplacians from Laplacians"),
            describe<R>("s = 1, the second Laplacian from values, normal derivatives and Laplacians, before what data "
                        "do not determine is held down",
                        k3, LeastSquares<R>(k3).rank(), data.topRows(k3.rows()), found.own.bottomRows(n))};
    return found;
  }
};

const RegisterCoordinateKind register_triharmonic_boundary{
    {.name = "triharmonic_boundary",
     .source = "[W12] Appendix B of order 3, after the errata",
     .own_dimension = 2,
     .prepare = prepare_boundary<TriharmonicScheme>,
     .parameters = boundary_parameters(collocations(), "where the boundary's equations are asked to hold"),
     .other_evaluations = {offset_evaluation},
     .meets_boundary_data = true,
     .refuses = why_not_refined}};

}  // namespace
}  // namespace cageproof::solved
