// SPDX-License-Identifier: MIT
#include "harmonic_in_space.h"

#include "../boundary_in_space/missed_vertices.h"
#include "../boundary_in_space/square_system.h"
#include "../boundary_in_space/surface_layer.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <tuple>

namespace cageproof::solved {
namespace {

constexpr int densities_a_piece = 3;

Evaluation single_layer_by(const std::string& name) {
  constexpr std::string_view formula = "triangle.affine_single_layer";
  return name.empty() ? EvaluationRegister::instance().with_role(formula, Role::Recommended).value()
                      : evaluation_named(formula, name);
}

/// lambda = phi + psi D: the cage's own phi, which knows on which side of the cage a point lies and has the exact
/// limits on it, and the single layers of the pieces' corners times their normal derivatives D.
class HarmonicInSpace final : public CoordinatesInDouble<HarmonicInSpace>,
                              public SolvesSystems,
                              public HasLimits,
                              public HasTerms {
 public:
  HarmonicInSpace(const Cage& cage, const CoordinateOptions& options, int level)
      : name_(cage.name()),
        green_(cage, coordinate_kind_named("green"), CoordinateOptions{options.evaluation, options.triangulation, {}}),
        evaluation_(single_layer_by(options.evaluation)),
        surface_(cage, green_.elements(), level, densities_a_piece) {
    blocks_ = {{.label = "lambda",
                .owner = Owner::Vertex,
                .size = static_cast<int>(green_.elements().vertices().size()),
                .shape = {},
                .reproduces = Reproduces::Vertices}};
    blocks_[0].trace.kind = CoordinateBlock::Trace::Kind::Zero;
    prepared<double>();
    require_vertices_met(*this, blocks_[0], surface_, name_, "harmonic", "values", 0.25);
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return std::min(green_.max_order(), evaluation_.max_order()); }
  std::string evaluation() const override { return evaluation_.name(); }
  // Limits, and so normal derivatives, have 50 digits at most.
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits100 && scalar != ScalarKind::Digits200 && evaluation_.supports(scalar) &&
           green_.is_exact_in(scalar);
  }
  bool is_prompt_in(ScalarKind scalar) const override {
    // In multiprecision a layer takes parts of a millisecond, and there is one per piece and unknown.
    return scalar == ScalarKind::Float || scalar == ScalarKind::Double || unknowns() <= 150;
  }
  const SolvesSystems* systems() const override { return this; }
  const HasLimits* limits() const override { return this; }
  const HasTerms* terms() const override { return this; }
  std::vector<SolvedSystem> solved() const override { return prepared<double>().described; }

  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    CoordinateTable<double> layers = prepared<double>().layer->around(green_.elements(), points, order);
    for (auto& numbers : layers.tensors)
      for (double& x : numbers) x = std::abs(x);
    std::vector<CoordinateTable<double>> own(1);
    own[0].stride = tables[0].stride;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::vector<Result<double>> terms = green_.terms_at(points[p], order);
      for (int o = 0; o <= order; ++o)
        own[0].tensors[o].insert(own[0].tensors[o].end(), terms[0].of(o).begin(), terms[0].of(o).end());
    }
    put<double>(prepared<double>().slopes.cwiseAbs(), own[0], layers, points.size(), 0, order, tables[0]);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put_limits<double>(places, order, tables[0]);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put_limits<Mp50>(places, order, tables[0]);
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    constexpr std::size_t together = 32;  // tables of all corners at so many points stay in the cache
    for (std::size_t first = 0; first < points.size(); first += together) {
      const auto some = points.subspan(first, std::min(together, points.size() - first));
      put<R>(prepared<R>().slopes, green_.at<R>(some, order)[0],
             prepared<R>().layer->around(green_.elements(), some, order), some.size(), first, order, tables[0]);
    }
  }

 private:
  template <Scalar R>
  struct Prepared {
    std::once_flag once;
    std::unique_ptr<SurfaceLayer<R>> layer;
    std::vector<SolvedSystem> described;
    Matrix<R> slopes;  // D transposed, in the frame: one row per vertex, one column per corner of a piece
  };

  int unknowns() const { return surface_.pieces() * densities_a_piece; }

  template <Scalar R>
  const Prepared<R>& prepared() const {
    Prepared<R>& made = std::get<Prepared<R>>(prepared_);
    std::call_once(made.once, [&] {
      made.layer = std::make_unique<SurfaceLayer<R>>(surface_, evaluation_);
      if constexpr (std::same_as<R, Mp100>) {
        made.slopes = prepared<Mp50>().slopes.template cast<R>();
      } else {
        SquareSolution<R> solution = slopes<R>(*made.layer);
        made.slopes = solution.found.transpose();
        made.described = std::move(solution.described);
      }
    });
    return made;
  }

  // Green's identity on the cage, from inside: psi D = hats - phi.
  template <Scalar R>
  SquareSolution<R> slopes(const SurfaceLayer<R>& layer) const {
    const std::vector<PlaceOnTriangle> places = collocation_places(surface_);
    return solve_square<R>("Green's identity, the normal derivative from values", layer.rows(places),
                           missing_values<R>(places));
  }

  // The hat functions at places, less their double layer's limit: one row per place, one column per vertex.
  template <Scalar R>
  Matrix<R> missing_values(const std::vector<PlaceOnTriangle>& places) const {
    constexpr std::size_t together = 64;
    Matrix<R> found = Matrix<R>::Zero(static_cast<Eigen::Index>(places.size()), blocks_[0].size);
    std::vector<Touching> some;
    for (std::size_t first = 0; first < places.size(); first += together) {
      some.clear();
      for (std::size_t p = first; p < std::min(first + together, places.size()); ++p)
        some.push_back(places[p].touching());
      const CoordinateTable<R> phi = green_.limits_at<R>(some, 0)[0];
      for (std::size_t p = 0; p < some.size(); ++p) {
        const auto row = static_cast<Eigen::Index>(first + p);
        R sum = -1;
        for (Eigen::Index v = 0; v < found.cols(); ++v) {
          found(row, v) = -phi.tensors[0][p * phi.stride[0] + static_cast<std::size_t>(v)];
          sum -= found(row, v);
        }
        require_one(static_cast<double>(sum) + 1, some[p].element);
        const auto corners = surface_.vertices_of(some[p].element);
        const R second(places[first + p].second), third(places[first + p].third);
        found(row, corners[0]) += 1 - second - third;
        found(row, corners[1]) += second;
        found(row, corners[2]) += third;
      }
    }
    return found;
  }

  void require_one(double sum, int element) const {
    if (!std::isfinite(sum))
      throw InputError(
          fmt::format("{}: no harmonic coordinates: layers of a cage of size {:.3g} leave the range of "
                      "double; take another unit of length",
                      name_, surface_.unit()));
    if (std::abs(sum - 1) <= 1e-6) return;
    throw InputError(fmt::format(
        "{}: no harmonic coordinates: on triangle {} (counted from 0, quads split) Green coordinates sum to {:.3g}, "
        "not to 1: the cage overlaps itself, or is too thin there; make one surface of it (a union), or take "
        "mean_value",
        name_, element, sum));
  }

  template <Scalar R>
  void put_limits(std::span<const Touching> places, int order, CoordinateTable<R>& to) const {
    const Prepared<R>& known = prepared<R>();
    for (std::size_t p = 0; p < places.size(); ++p) {
      CoordinateTable<R> layers = known.layer->table(1, order);
      const Vec3<R> point =
          RefinedSurface::at<R>(surface_.corners_of<R>(places[p].element), places[p].basis[1], places[p].basis[2]);
      known.layer->add_on(point, places.subspan(p, 1), order, layers);
      put<R>(known.slopes, green_.limits_at<R>(places.subspan(p, 1), order)[0], layers, 1, p, order, to);
    }
  }

  // Where points begin in the tables that are put in: at `first`.
  template <Scalar R>
  void put(const Matrix<R>& slopes, const CoordinateTable<R>& own, const CoordinateTable<R>& layers, std::size_t points,
           std::size_t first, int order, CoordinateTable<R>& to) const {
    using Rows = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    R unit = 1;
    for (int o = 0; o <= order; ++o, unit /= R(surface_.unit())) {
      const auto width = static_cast<Eigen::Index>(derivative_count(3, o));
      if (o == 0) {
        // All points at once, one column per point.
        const Eigen::Map<const Matrix<R>> layer(layers.tensors[0].data(), unknowns(),
                                                static_cast<Eigen::Index>(points));
        const Eigen::Map<const Matrix<R>> phi(own.tensors[0].data(), blocks_[0].size,
                                              static_cast<Eigen::Index>(points));
        Eigen::Map<Matrix<R>>(&to.tensors[0][first * to.stride[0]], phi.rows(), phi.cols()) = phi + slopes * layer;
        continue;
      }
      for (std::size_t p = 0; p < points; ++p) {
        const Eigen::Map<const Rows> layer(&layers.tensors[o][p * layers.stride[o]], unknowns(), width);
        const Eigen::Map<const Rows> phi(&own.tensors[o][p * own.stride[o]], blocks_[0].size, width);
        Eigen::Map<Rows>(&to.tensors[o][(first + p) * to.stride[o]], phi.rows(), width) = phi + unit * (slopes * layer);
      }
    }
  }

  std::string name_;
  CageCoordinates green_;
  Evaluation evaluation_;
  RefinedSurface surface_;
  std::vector<CoordinateBlock> blocks_;
  mutable std::tuple<Prepared<double>, Prepared<Mp50>, Prepared<Mp100>> prepared_;
};

}  // namespace

std::shared_ptr<const PreparedCoordinates> prepare_harmonic_in_space(const Cage& cage, const CoordinateOptions& options,
                                                                     int level) {
  return std::make_shared<HarmonicInSpace>(cage, options, level);
}

std::string why_too_large_in_space(const Cage& cage) {
  return why_too_many_unknowns(cage, densities_a_piece, default_level);
}

}  // namespace cageproof::solved
