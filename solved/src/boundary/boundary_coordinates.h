// SPDX-License-Identifier: MIT
// Coordinates of polygons that are layers of the boundary with densities solved for once per cage.
#pragma once

#include "boundary_layers.h"
#include "boundary_parameters.h"
#include "on_edges.h"
#include "collocation.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <tuple>

namespace cageproof::solved {

/// The solution of a scheme, in the polygon's frame.
template <Scalar R>
struct Densities {
  /// Solutions, one column per coordinate: those of values at vertices, of edges' normal derivatives, of Laplacians at
  /// vertices. From order 2 on, the first rows are Laplacians, one per node.
  Matrix<R> own;
  /// The densities of layer number `layer` of Scheme::unknown are, summed over its shares, `matrix` times the rows of
  /// `own` from `row` on; those themselves where the matrix is empty. Layers are put together before they are
  /// multiplied with `own`, which is large where a cage is thin, and vanishes of affine maps.
  struct Share {
    std::size_t layer;
    Eigen::Index row;
    Matrix<R> matrix;
  };
  std::vector<Share> shares;
  std::vector<SolvedSystem> systems;  ///< in double alone, and where asked for
  /// The part of `own` that rounding to double dropped, where `own` was solved in 50 digits; otherwise empty. Affine
  /// maps, for which `own` vanishes, would otherwise keep the roundings of its large numbers.
  Matrix<R> rest = {};
};

inline constexpr std::string_view offset_evaluation = "offset-1e-6";

/// A row of coordinates is phi^H of the cage itself, or psi^H (zero for those of Laplacians), plus the layers of the
/// refined polygon times their densities. The first comes from the cage's own Green coordinates, which know on which
/// side of the cage a point lies and have the exact limits on it; the second changes only by rounding where nodes are
/// rounded.
///
/// With the evaluation `offset-1e-6` of kinds with normals, equations are asked to hold on the cage offset inwards by
/// 1e-6 of its diameter, as the paper does, instead of in the limit.
///
/// Scheme: `order`, 1 for harmonic functions of values at vertices, 2 for biharmonic ones of normal derivatives at
/// edges, too, 3 for triharmonic ones of Laplacians at vertices, too; `unknown`, the layers that densities are of;
/// `label` of the first block; solve<R>(polygon, layers, parameters, inset, whether to describe the systems).
template <class Scheme>
class BoundaryCoordinates final : public CoordinatesInDouble<BoundaryCoordinates<Scheme>>,
                                  public SolvesSystems,
                                  public HasLimits,
                                  public HasTerms,
                                  public SolvesLaplacians {
 public:
  BoundaryCoordinates(const Cage& cage, const CoordinateOptions& options)
      : inset_(has_normals && options.evaluation == offset_evaluation ? 1e-6 : 0),
        green_(cage, coordinate_kind_named("green"), CoordinateOptions{.evaluation = of_layers(options)}),
        evaluations_(layer_evaluations(of_layers(options), Scheme::order)),
        polygon_(cage, static_cast<int>(options.parameters[0]), unit_of(options.parameters)),
        parameters_(options.parameters) {
    blocks_.push_back({.label = std::string(Scheme::label),
                       .owner = Owner::Vertex,
                       .size = polygon_.vertices(),
                       .shape = {},
                       .reproduces = Reproduces::Vertices});
    if (!has_normals) blocks_[0].trace.kind = CoordinateBlock::Trace::Kind::Zero;
    if (has_normals)
      blocks_.push_back({.label = "beta",
                         .owner = Owner::Element,
                         .size = polygon_.edges(),
                         .shape = {},
                         .reproduces = Reproduces::Normals,
                         .degree = 1});
    if (Scheme::order == 3)
      blocks_.push_back(
          {.label = "gamma", .owner = Owner::Vertex, .size = polygon_.vertices(), .shape = {}, .degree = 2});
    for (const CoordinateBlock& block : blocks_) {
      const auto largest = power_of_unit<double>(block.degree);
      if (!std::isnormal(largest))
        throw InputError(
            fmt::format("{}: {}, which has the unit of a length to the power of {}, leaves the range of "
                        "double in cages of {:.3g}",
                        cage.name(), block.label, block.degree, polygon_.unit()));
    }
    for (const Evaluation& e : evaluations_) max_order_ = std::min(max_order_, e.max_order());
    prepared<double>();
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return max_order_; }
  std::string evaluation() const override {
    return inset_ == 0 ? evaluations_[0].name() : std::string(offset_evaluation);
  }
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits200 &&
           std::ranges::all_of(evaluations_, [&](const Evaluation& e) { return e.supports(scalar); });
  }
  bool is_prompt_in(ScalarKind scalar) const override {
    // Solving takes the cube of the number of nodes.
    return scalar == ScalarKind::Float || scalar == ScalarKind::Double || polygon_.nodes() <= 64;
  }
  const SolvesSystems* systems() const override { return this; }
  const HasLimits* limits() const override { return this; }
  const HasTerms* terms() const override { return this; }
  const SolvesLaplacians* boundary_laplacians() const override { return has_normals ? this : nullptr; }
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    Densities<double> sizes = prepared<double>().densities;
    sizes.own = sizes.own.cwiseAbs().eval();
    sizes.rest.resize(0, 0);
    for (auto& share : sizes.shares) share.matrix = share.matrix.cwiseAbs().eval();
    Parts<double> parts = parts_at<double>(points, order);
    const auto make_sizes = [](std::vector<double>& numbers) {
      for (double& x : numbers) x = std::abs(x);
    };
    for (auto* part : {&parts.layers, &parts.own})
      for (CoordinateTable<double>& table : *part) std::ranges::for_each(table.tensors, make_sizes);
    make_sizes(parts.single);
    put(sizes, parts, points.size(), 0, order, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put_limits<double>(places, order, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put_limits<Mp50>(places, order, tables);
  }
  void fill_boundary_laplacians(std::vector<CoordinateTable<double>>& tables) const override {
    put_laplacians<double>(tables);
  }
  void fill_boundary_laplacians(std::vector<CoordinateTable<Mp50>>& tables) const override {
    put_laplacians<Mp50>(tables);
  }
  std::vector<SolvedSystem> solved() const override {
    // Singular values take longer than solving does, and few ask for them.
    return Scheme::template solve<double>(polygon_, *prepared<double>().layers, parameters_, inset_in_frame(), true)
        .systems;
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    constexpr std::size_t together = 32;  // tables of all nodes at so many points stay in the cache
    for (std::size_t first = 0; first < points.size(); first += together)
      compute_block(points.subspan(first, std::min(together, points.size() - first)), first, order, tables);
  }

 private:
  static constexpr bool has_normals = Scheme::order >= 2;
  template <Scalar R>
  using At = RefinedPolygon::At<R>;

  double inset_in_frame() const { return inset_ * polygon_.diameter(); }

  std::string of_layers(const CoordinateOptions& options) const {
    return inset_ == 0 ? options.evaluation : std::string();
  }

  template <Scalar R>
  struct Prepared {
    std::once_flag once;
    std::unique_ptr<BoundaryLayers<R>> layers;
    Densities<R> densities;  // transposed
  };

  template <Scalar R>
  const Prepared<R>& prepared() const {
    Prepared<R>& made = std::get<Prepared<R>>(prepared_);
    std::call_once(made.once, [&] {
      made.layers = std::make_unique<BoundaryLayers<R>>(polygon_, evaluations_);
      if constexpr (std::same_as<R, double>)
        if (takes_50_digits(*made.layers)) {
          made.densities = rounded(prepared<Mp50>().densities);
          return;
        }
      made.densities = Scheme::template solve<R>(polygon_, *made.layers, parameters_, inset_in_frame(), false);
      made.densities.own = made.densities.own.transpose().eval();
      for (auto& share : made.densities.shares) share.matrix = share.matrix.transpose().eval();
    });
    return made;
  }

  // Where short edges make systems of such a condition that double has too few digits, and 50 digits take a second or
  // so.
  bool takes_50_digits(const BoundaryLayers<double>& layers) const {
    constexpr double most_in_double = 1e6;
    if (!polygon_.has_short_edge() || !is_exact_in(ScalarKind::Digits50) || !is_prompt_in(ScalarKind::Digits50))
      return false;
    // Systems that are solved one after the other enlarge each other's roundings.
    double condition = 1;
    for (const SolvedSystem& system :
         Scheme::template solve<double>(polygon_, layers, parameters_, inset_in_frame(), true).systems)
      condition *= system.condition;
    return condition > most_in_double;
  }

  static Densities<double> rounded(const Densities<Mp50>& densities) {
    Densities<double> found{densities.own.template cast<double>(), {}, {}};
    found.rest = (densities.own - found.own.template cast<Mp50>()).template cast<double>();
    for (const auto& [layer, row, matrix] : densities.shares)
      found.shares.push_back({layer, row, matrix.template cast<double>()});
    return found;
  }

  template <Scalar R>
  void compute_block(std::span<const Vec3<R>> points, std::size_t first, int order,
                     std::span<CoordinateTable<R>> tables) const {
    put(prepared<R>().densities, parts_at<R>(points, order), points.size(), first, order, tables);
  }

  // The parts that coordinates are put together from, at a block of points.
  template <Scalar R>
  struct Parts {
    std::vector<CoordinateTable<R>> layers;  // of the refined polygon, in its frame
    std::vector<CoordinateTable<R>> own;     // phi^H and psi^H of the cage
    std::vector<R> single;                   // psi^H of the cage in the polygon's frame: [point][edge]
  };

  template <Scalar R>
  Parts<R> parts_at(std::span<const Vec3<R>> points, int order) const {
    const BoundaryLayers<R>& layers = *prepared<R>().layers;
    Parts<R> parts;
    for (const Layer layer : Scheme::unknown) parts.layers.push_back(layers.table(layer, points.size(), order));
    add_layers(layers, points, order, std::span<CoordinateTable<R>>(parts.layers));
    parts.own = green_.at<R>(points, order);
    if (has_normals) parts.single = single_layer_in_frame<R>(places_of<R>(points));
    return parts;
  }

  // Limits at places on edges, which basis functions state.
  template <Scalar R>
  void put_limits(std::span<const Touching> places, int order, std::span<CoordinateTable<R>> tables) const {
    const BoundaryLayers<R>& layers = *prepared<R>().layers;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const OnEdge<R> on{places[p].element, R(places[p].basis[1]) * polygon_.pieces_an_edge()};
      const At<R> at = polygon_.on<R>(on.edge, on.steps);
      Parts<R> parts;
      parts.layers.reserve(std::size(Scheme::unknown));
      for (const Layer layer : Scheme::unknown) parts.layers.push_back(layers.table(layer, 1, order));
      layers.add_on(Scheme::unknown, at, std::span(&on, 1), order, parts.layers);
      parts.own = green_.limits_at<R>(places.subspan(p, 1), order);
      if (has_normals) parts.single = single_layer_in_frame<R>(std::span(&at, 1));
      put(prepared<R>().densities, parts, 1, p, order, tables);
    }
  }

  // Solutions have one row per coordinate here, in the frame's unit.
  template <Scalar R>
  void put_laplacians(std::vector<CoordinateTable<R>>& tables) const {
    const Matrix<R>& own = prepared<R>().densities.own;
    tables.clear();
    Eigen::Index above = 0;
    for (const CoordinateBlock& block : blocks_) {
      const R unit = power_of_unit<R>(block.degree - 2);
      CoordinateTable<R>& table = tables.emplace_back();
      table.stride[0] = static_cast<std::size_t>(block.size);
      table.tensors[0].reserve(static_cast<std::size_t>(polygon_.nodes()) * table.stride[0]);
      for (Eigen::Index node = 0; node < polygon_.nodes(); ++node)
        for (Eigen::Index k = 0; k < block.size; ++k) table.tensors[0].push_back(unit * own(above + k, node));
      above += block.size;
    }
  }

  template <Scalar R>
  void put(const Densities<R>& densities, const Parts<R>& parts, std::size_t points, std::size_t first, int order,
           std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points; ++p)
      for (int o = 0; o <= order; ++o) {
        const Matrix<R> sums = sums_at<R>(densities, parts.layers, p, o);
        const int width = static_cast<int>(derivative_count(2, o));
        int above = 0;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
          const R unit = power_of_unit<R>(blocks_[b].degree - o);
          // Only the first two blocks have a layer of the cage itself.
          const R* const from = b < 2 ? &parts.own[b].tensors[o][p * parts.own[b].stride[o]] : nullptr;
          R* const to = &tables[b].tensors[o][(first + p) * tables[b].stride[o]];
          for (int k = 0; k < blocks_[b].size; ++k)
            for (int d = 0; d < width; ++d) {
              const R& sum = sums(above + k, d);
              // The single layer's own value has the logarithm of the user's unit.
              if (b == 1 && o == 0) to[k] = unit * (parts.single[p * polygon_.edges() + k] + sum);
              else if (b < 2) to[k * width + d] = from[k * width + d] + unit * sum;
              else to[k * width + d] = unit * sum;
            }
          above += blocks_[b].size;
        }
      }
  }

  template <Scalar R>
  R power_of_unit(int exponent) const {
    using std::pow;
    return pow(R(polygon_.unit()), exponent);
  }

  // The layers at a point times densities: one row per coordinate, one column per derivative.
  template <Scalar R>
  Matrix<R> sums_at(const Densities<R>& densities, const std::vector<CoordinateTable<R>>& layers, std::size_t p,
                    int order) const {
    const auto here = [&](const CoordinateTable<R>& layer) {
      using RowMajor = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      const auto width = static_cast<Eigen::Index>(derivative_count(2, order));
      const auto count = static_cast<Eigen::Index>(layer.stride[order]) / width;
      return Eigen::Map<const RowMajor>(&layer.tensors[order][p * layer.stride[order]], count, width);
    };
    Matrix<R> together = Matrix<R>::Zero(densities.own.cols(), static_cast<Eigen::Index>(derivative_count(2, order)));
    for (const auto& share : densities.shares) {
      const auto layer = here(layers[share.layer]);
      if (share.matrix.size() == 0) together.middleRows(share.row, layer.rows()) += layer;
      else together.middleRows(share.row, share.matrix.rows()).noalias() += share.matrix * layer;
    }
    if constexpr (std::same_as<R, double>)
      if (densities.rest.size() > 0) return with_rest(densities, together);
    return densities.own * together;
  }

  // `own` times layers as if in twice the digits of double: terms are as much larger than their sum as the cage is
  // thin.
  static Matrix<double> with_rest(const Densities<double>& densities, const Matrix<double>& layers) {
    Matrix<double> found = densities.rest * layers;
    for (Eigen::Index i = 0; i < found.rows(); ++i)
      for (Eigen::Index c = 0; c < found.cols(); ++c) {
        double sum = 0, low = found(i, c);
        for (Eigen::Index k = 0; k < layers.rows(); ++k) {
          const double factor = densities.own(i, k), product = factor * layers(k, c), next = sum + product,
                       added = next - sum;
          low += std::fma(factor, layers(k, c), -product) + ((sum - (next - added)) + (product - added));
          sum = next;
        }
        found(i, c) = sum + low;
      }
    return found;
  }

  template <Scalar R>
  void add_layers(const BoundaryLayers<R>& layers, std::span<const Vec3<R>> points, int order,
                  std::span<CoordinateTable<R>> tables) const {
    const std::vector<At<R>> at = places_of<R>(points);
    std::vector<std::vector<OnEdge<R>>> on;
    for (const Vec3<R>& point : points) on.push_back(on_edges(polygon_, green_.elements(), point));
    if (std::ranges::all_of(on, [](const auto& edges) { return edges.empty(); }))
      return layers.add(Scheme::unknown, at, order, tables);
    for (std::size_t p = 0; p < points.size(); ++p) {
      std::vector<CoordinateTable<R>> one;
      one.reserve(std::size(Scheme::unknown));
      for (const Layer layer : Scheme::unknown) one.push_back(layers.table(layer, 1, order));
      if (on[p].empty()) layers.add(Scheme::unknown, std::span(&at[p], 1), order, one);
      else layers.add_on(Scheme::unknown, at[p], on[p], order, one);
      for (std::size_t k = 0; k < one.size(); ++k)
        for (int o = 0; o <= order; ++o)
          std::ranges::copy(one[k].tensors[o], &tables[k].tensors[o][p * tables[k].stride[o]]);
    }
  }

  template <Scalar R>
  static std::vector<At<R>> places_of(std::span<const Vec3<R>> points) {
    std::vector<At<R>> at;
    at.reserve(points.size());
    for (const Vec3<R>& point : points) at.push_back({point});
    return at;
  }

  // psi^H of the cage's edges in the polygon's frame.
  template <Scalar R>
  std::vector<R> single_layer_in_frame(std::span<const At<R>> at) const {
    std::vector<R> found(at.size() * polygon_.edges());
    for (int e = 0; e < polygon_.edges(); ++e) {
      const int from = polygon_.seer(e, 0);
      std::vector<Vec3<R>> seen;
      seen.reserve(at.size());
      for (const At<R>& place : at) seen.push_back(polygon_.seen_from<R>(from, place));
      const std::array<Vec3<R>, 2> ends{polygon_.along<R>(e, R(0), from),
                                        polygon_.along<R>(e, R(polygon_.pieces_an_edge()), from)};
      BatchOutput<R> output{
          .stride = {static_cast<std::size_t>(polygon_.edges())}, .dim = 2, .slots = std::span(&e, 1)};
      output.tensors[0] = found.data();
      evaluations_[static_cast<std::size_t>(Layer::Single)](Batch<R>{ends, seen, 0, {}}, output);
    }
    return found;
  }

  double inset_;  // in diameters
  CageCoordinates green_;
  LayerEvaluations evaluations_;
  RefinedPolygon polygon_;
  std::vector<double> parameters_;
  std::vector<CoordinateBlock> blocks_;
  int max_order_ = 2;
  mutable std::tuple<Prepared<double>, Prepared<Mp50>, Prepared<Mp100>> prepared_;
};

/// The function that prepares a kind with that scheme (CoordinateKind::prepare).
template <class Scheme>
std::shared_ptr<const PreparedCoordinates> prepare_boundary(const Cage& cage, const CoordinateOptions& options) {
  return std::make_shared<BoundaryCoordinates<Scheme>>(cage, options);
}

}  // namespace cageproof::solved
