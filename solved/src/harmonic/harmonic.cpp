// SPDX-License-Identifier: MIT
// Harmonic coordinates (Joshi et al. 2007) by boundary elements: of polygons, the baseline of [W12], and of cages in
// space.
#include "harmonic_in_space.h"

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

std::vector<KindParameter> harmonic_parameters() {
  std::vector<KindParameter> all =
      boundary_parameters(harmonic_collocations(), "in the plane: where the boundary's equation is asked to hold");
  all[0].meaning = "in the plane: that each edge is cut into";
  all.push_back({{.name = "level", .preset = default_level, .lowest = -1, .highest = 6, .whole = true},
                 "in space: times that each triangle is split in four"});
  return all;
}

// An option that would change nothing is an error.
void require_default(const Cage& cage, const std::vector<double>& given, std::size_t which, std::string_view instead) {
  const KindParameter known = harmonic_parameters()[which];
  if (given[which] != known.preset)
    throw InputError(fmt::format("{}: harmonic coordinates in {} have no parameter {}; {}", cage.name(),
                                 cage.dimension() == 3 ? "space" : "the plane", known.name, instead));
}

std::shared_ptr<const PreparedCoordinates> prepare_harmonic(const Cage& cage, const CoordinateOptions& options) {
  constexpr std::size_t pieces = 0, collocation = 1, level = 2;
  if (cage.dimension() == 2) {
    require_default(cage, options.parameters, level, "take pieces, which each edge is cut into");
    CoordinateOptions of_polygon = options;
    of_polygon.parameters.resize(level);
    return prepare_boundary<HarmonicScheme>(cage, of_polygon);
  }
  require_default(cage, options.parameters, pieces, "take level, the times that each triangle is split in four");
  require_default(cage, options.parameters, collocation, "equations hold at three places within each piece");
  return prepare_harmonic_in_space(cage, options, static_cast<int>(options.parameters[level]));
}

std::string why_harmonic_is_refused(const Cage& cage) {
  return cage.dimension() == 2 ? why_not_refined(cage) : why_too_large_in_space(cage);
}

const RegisterCoordinateKind register_harmonic{
    {.name = "harmonic",
     .source = "Joshi et al. 2007, by the boundary elements of [W12] Section 4.2, in space by affine ones",
     .own_dimension = 0,
     .prepare = prepare_harmonic,
     .parameters = harmonic_parameters(),
     .approximates = "harmonic_goursat",
     .meets_boundary_data = true,
     .solves_on_samples = true,
     .refuses = why_harmonic_is_refused}};

}  // namespace
}  // namespace cageproof::solved
