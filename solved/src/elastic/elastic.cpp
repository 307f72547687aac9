// SPDX-License-Identifier: MIT
// Elastic bodies with given displacements on the border of a polygon or a cage in space, by boundary elements ([C23]
// Sections 3 and 4.2).
#include "elastic_in_space.h"
#include "elastic_layers.h"

#include "../boundary/collocation.h"
#include "../boundary/boundary_parameters.h"
#include "../boundary/on_edges.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <tuple>

namespace cageproof::solved {
namespace {

struct ElasticCollocation {
  std::string_view name;
  PiecePoints points;
};

const std::vector<ElasticCollocation>& elastic_collocations() {
  static const std::vector<ElasticCollocation> all{{"vertices", {1, {0}}},
                                                   {"vertices-and-midpoints", {2, {0, 1}}},
                                                   {"quarter-points", {4, {0, 1, 2, 3}}},
                                                   {"midpoints", {2, {1}}}};
  return all;
}

// The parameters' order.
enum : std::size_t { kPieces, kCollocation, kNu, kLevel };

std::vector<KindParameter> elastic_parameters() {
  std::vector<KindParameter> all =
      boundary_parameters(elastic_collocations(), "in the plane: where the boundary's equation is asked to hold");
  all[kPieces].meaning = "in the plane: that each edge is cut into";
  all.push_back({{.name = "nu", .preset = 0.3, .lowest = -1, .highest = 0.5}, "Poisson's ratio"});
  all.push_back({{.name = "level", .preset = default_elastic_level, .lowest = -1, .highest = 6, .whole = true},
                 "in space: times that each triangle is split in four"});
  return all;
}

// A piece has two unknowns.
constexpr int most_pieces = RefinedPolygon::most_nodes / 2;

std::string why_too_many(const std::string& cage, int edges, int pieces) {
  if (edges * pieces <= most_pieces) return {};
  return fmt::format("{}{} edges in {} pieces each are more than {} pieces", cage, edges, pieces, most_pieces);
}

std::string why_elastic_refuses(const Cage& cage) {
  if (cage.dimension() == 3) return why_elastic_is_too_large(cage);
  return why_too_many("", static_cast<int>(cage.faces().size()), default_pieces);
}

/// u = T u_b + K t: the cage's own traction layers of displacements that are affine on edges, plus Kelvin's
/// displacements of tractions that are constant on pieces, which were solved for: t = D u_b.
///
/// All is solved in the frame of RefinedPolygon, in which the polygon's diameter is one. The single layer is singular
/// for certain sizes of a domain (degenerate scales), a disc's radius exp(1/(2 (3 - 4 nu))) > 1 being one; its smallest
/// energy per squared force falls where a domain grows, so that none within such a disc has any, and sets of that
/// diameter lie in a disc of radius 1/sqrt(3).
class ElasticCoordinates final : public CoordinatesInDouble<ElasticCoordinates>, public SolvesSystems, public HasTerms {
 public:
  ElasticCoordinates(const Cage& cage, const CoordinateOptions& options)
      : parameters_(options.parameters),
        somigliana_(cage, coordinate_kind_named("somigliana"),
                    CoordinateOptions{.evaluation = options.evaluation, .parameters = {1, parameters_[kNu]}}),
        evaluations_(2, options.evaluation),
        polygon_(cage, static_cast<int>(parameters_[kPieces])),
        blocks_{{.label = "E",
                 .owner = Owner::Vertex,
                 .size = polygon_.vertices(),
                 .shape = {.rows = 2, .columns = 2},
                 .reproduces = Reproduces::Vertices}} {
    if (const std::string reason = why_too_many(cage.name() + ": ", polygon_.edges(), polygon_.pieces_an_edge());
        !reason.empty())
      throw InputError(reason);
    prepared<double>();
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override {
    return std::min(evaluations_.displacement.max_order(), evaluations_.traction.max_order());
  }
  std::string evaluation() const override { return evaluations_.displacement.name(); }
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits200 && evaluations_.displacement.supports(scalar) &&
           evaluations_.traction.supports(scalar);
  }
  bool is_prompt_in(ScalarKind scalar) const override {
    return scalar == ScalarKind::Float || scalar == ScalarKind::Double || polygon_.pieces() <= 32;
  }
  const SolvesSystems* systems() const override { return this; }
  const HasTerms* terms() const override { return this; }
  std::vector<SolvedSystem> solved() const override {
    const auto equations = prepared<double>().layers->equations(points());
    const auto units = traction_units<double>();
    return {describe("K t = (H - T) u, tractions from displacements",
                     Matrix<double>(equations.displacement * units.asDiagonal()), prepared<double>().rank,
                     equations.data,
                     Matrix<double>(units.cwiseInverse().asDiagonal() * prepared<double>().tractions.transpose()))};
  }
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    const auto make_sizes = [](std::vector<double>& numbers) {
      for (double& x : numbers) x = std::abs(x);
    };
    auto own = somigliana_.at<double>(points, order);
    auto layers = layers_at<double>(points, order);
    for (int o = 0; o <= order; ++o) make_sizes(own[0].tensors[o]), make_sizes(layers.tensors[o]);
    put<double>(prepared<double>().tractions.cwiseAbs(), own[0], layers, points.size(), 0, order, tables[0]);
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    constexpr std::size_t together = 32;  // tables of all pieces at so many points stay in the cache
    for (std::size_t first = 0; first < points.size(); first += together) {
      const auto block = points.subspan(first, std::min(together, points.size() - first));
      put<R>(prepared<R>().tractions, somigliana_.at<R>(block, order)[0], layers_at<R>(block, order), block.size(),
             first, order, tables[0]);
    }
  }

 private:
  template <Scalar R>
  struct Prepared {
    std::once_flag once;
    std::unique_ptr<ElasticLayers<R>> layers;
    Matrix<R> tractions;  ///< of unit displacements: a row a component of a vertex, a column one of a piece
    int rank = 0;
  };

  std::vector<CollocationPoint> points() const {
    return points_on(polygon_, elastic_collocations()[static_cast<std::size_t>(parameters_[kCollocation])].points);
  }

  // Units of the pieces' tractions, component by component, in which those of short pieces pull as much as those of
  // long ones: powers of two, which round nothing. Otherwise pieces 1e13 times shorter than others would count as
  // without effect.
  template <Scalar R>
  Eigen::Matrix<R, Eigen::Dynamic, 1> traction_units() const {
    std::vector<double> lengths;
    lengths.reserve(static_cast<std::size_t>(polygon_.edges()));
    for (int e = 0; e < polygon_.edges(); ++e) lengths.push_back(polygon_.line<double>(e).piece);
    const double longest = std::ranges::max(lengths);
    Eigen::Matrix<R, Eigen::Dynamic, 1> units(2 * polygon_.pieces());
    const Eigen::Index an_edge = 2 * polygon_.pieces_an_edge();
    for (int e = 0; e < polygon_.edges(); ++e)
      units.segment(e * an_edge, an_edge).setConstant(R(std::exp2(std::ilogb(longest / lengths[e]))));
    return units;
  }

  template <Scalar R>
  const Prepared<R>& prepared() const {
    Prepared<R>& made = std::get<Prepared<R>>(prepared_);
    std::call_once(made.once, [&] {
      made.layers = std::make_unique<ElasticLayers<R>>(polygon_, evaluations_, parameters_[kNu]);
      const auto equations = made.layers->equations(points());
      const auto units = traction_units<R>();
      const LeastSquares<R> system(Matrix<R>(equations.displacement * units.asDiagonal()));
      made.rank = system.rank();
      const Matrix<R> tractions = units.asDiagonal() * (system.inverse() * equations.data);
      made.tractions = tractions.transpose();
    });
    return made;
  }

  // Kelvin's displacements of all pieces. Points that are no doubles are taken to lie off the cage.
  template <Scalar R>
  CoordinateTable<R> layers_at(std::span<const Vec3<R>> points, int order) const {
    const ElasticLayers<R>& layers = *prepared<R>().layers;
    using At = RefinedPolygon::At<R>;
    std::vector<At> off;
    std::vector<std::size_t> places;
    CoordinateTable<R> all = layers.table(points.size(), order);
    const auto put = [&](const CoordinateTable<R>& from, std::size_t p, std::size_t to) {
      for (int o = 0; o <= order; ++o)
        std::copy_n(&from.tensors[o][p * all.stride[o]], all.stride[o], &all.tensors[o][to * all.stride[o]]);
    };
    for (std::size_t p = 0; p < points.size(); ++p) {
      const At at{points[p]};
      const std::vector<OnEdge<R>> on = on_edges(polygon_, somigliana_.elements(), points[p]);
      if (on.empty()) {
        off.push_back(at);
        places.push_back(p);
        continue;
      }
      CoordinateTable<R> one = layers.table(1, order);
      layers.add_on(at, on, order, one);
      put(one, 0, p);
    }
    CoordinateTable<R> rest = layers.table(off.size(), order);
    layers.add(off, order, rest);
    for (std::size_t k = 0; k < off.size(); ++k) put(rest, k, places[k]);
    return all;
  }

  template <Scalar R>
  void put(const Matrix<R>& tractions, const CoordinateTable<R>& own, const CoordinateTable<R>& layers,
           std::size_t points, std::size_t first, int order, CoordinateTable<R>& table) const {
    using std::pow;
    for (int o = 0; o <= order; ++o) {
      const auto width = static_cast<Eigen::Index>(derivative_count(2, o));
      const R unit = pow(R(polygon_.unit()), -o);
      Matrix<R> layer(2 * polygon_.pieces(), 2 * width);  // a row a component of a traction
      for (std::size_t p = 0; p < points; ++p) {
        const R* const from = &layers.tensors[o][p * layers.stride[o]];
        for (Eigen::Index piece = 0; piece < polygon_.pieces(); ++piece)
          for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index d = 0; d < width; ++d)
              layer(2 * piece + i % 2, i / 2 * width + d) = from[(4 * piece + i) * width + d];
        const Matrix<R> sums = tractions * layer;
        const R* const mine = &own.tensors[o][p * own.stride[o]];
        R* const to = &table.tensors[o][(first + p) * table.stride[o]];
        for (Eigen::Index v = 0; v < polygon_.vertices(); ++v)
          for (Eigen::Index i = 0; i < 4; ++i)
            for (Eigen::Index d = 0; d < width; ++d) {
              const Eigen::Index k = (4 * v + i) * width + d;
              to[k] = mine[k] + unit * sums(2 * v + i % 2, i / 2 * width + d);
            }
      }
    }
  }

  std::vector<double> parameters_;
  CageCoordinates somigliana_;
  ElasticEvaluations evaluations_;
  RefinedPolygon polygon_;
  std::vector<CoordinateBlock> blocks_;
  mutable std::tuple<Prepared<double>, Prepared<Mp50>, Prepared<Mp100>> prepared_;
};

// An option that would change nothing is an error.
void require_preset(const Cage& cage, const std::vector<double>& given, std::size_t which, std::string_view instead) {
  const KindParameter known = elastic_parameters()[which];
  if (given[which] != known.preset)
    throw InputError(fmt::format("{}: elastic coordinates in {} have no parameter {}; {}", cage.name(),
                                 cage.dimension() == 3 ? "space" : "the plane", known.name, instead));
}

std::shared_ptr<const PreparedCoordinates> prepare_elastic(const Cage& cage, const CoordinateOptions& options) {
  const std::vector<double>& given = options.parameters;
  if (cage.dimension() == 2) {
    require_preset(cage, given, kLevel, "take pieces, which each edge is cut into");
    return std::make_shared<ElasticCoordinates>(cage, options);
  }
  require_preset(cage, given, kPieces, "take level, the times that each triangle is split in four");
  require_preset(cage, given, kCollocation, "the equation is asked to hold at the centroid of each piece");
  return prepare_elastic_in_space(cage, options, given[kNu], static_cast<int>(given[kLevel]));
}

const RegisterCoordinateKind register_elastic{{.name = "elastic",
                                               .source = "[C23] Sections 3 and 4.2, by boundary elements",
                                               .own_dimension = 0,
                                               .prepare = prepare_elastic,
                                               .parameters = elastic_parameters(),
                                               .solves_on_samples = true,
                                               .refuses = why_elastic_refuses}};

}  // namespace
}  // namespace cageproof::solved
