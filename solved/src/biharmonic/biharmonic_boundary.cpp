// SPDX-License-Identifier: MIT
// Biharmonic coordinates of polygons ([W12] Section 4, after the errata).
#include "../boundary/boundary_coordinates.h"
#include "../boundary/boundary_parameters.h"
#include "../boundary/polyharmonic_equations.h"

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
    const PolyharmonicEquations<R> equations(polygon, layers, parameters[1], inset);
    const LeastSquares<R> second(equations.biharmonic);
    Densities<R> found{second.inverse() * equations.data, {{0, 0, {}}, {1, 0, equations.slopes}}, {}};
    if constexpr (std::same_as<R, double>)
      if (described)
        found.systems = {equations.described("Eq 14, the Laplacian's normal derivative from the Laplacian"),
                         describe<R>("Eq 13, the Laplacian from values and normal derivatives", equations.biharmonic,
                                     second.rank(), equations.data, found.own)};
    return found;
  }
};

std::vector<KindParameter> parameters() {
  std::vector<KindParameter> all =
      boundary_parameters(collocations(), "where the boundary's equations are asked to hold");
  all.push_back(unit_parameter());
  return all;
}

const RegisterCoordinateKind register_biharmonic_boundary{{.name = "biharmonic_boundary",
                                                           .source = "[W12] Section 4, Eq 17-19 after the errata",
                                                           .own_dimension = 2,
                                                           .prepare = prepare_boundary<BiharmonicScheme>,
                                                           .parameters = parameters(),
                                                           .other_evaluations = {offset_evaluation},
                                                           .approximates = "biharmonic_goursat",
                                                           .meets_boundary_data = true,
                                                           .refuses = why_not_refined}};

}  // namespace
}  // namespace cageproof::solved
