// SPDX-License-Identifier: MIT
#include "elastic_in_space.h"

#include "elastic_surface.h"

#include "../boundary_in_space/missed_vertices.h"
#include "../boundary_in_space/square_system.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/memory.h"

#include <fmt/format.h>

#include <cmath>
#include <mutex>
#include <tuple>

namespace cageproof::solved {
namespace {

/// E = T + K D: the cage's own traction layer of displacements that are affine on triangles, and Kelvin's displacements
/// of tractions that are constant on pieces, which were solved for: t = D u. In space the single layer is regular at
/// every size of the cage.
class ElasticInSpace final : public CoordinatesInDouble<ElasticInSpace>,
                             public SolvesSystems,
                             public HasLimits,
                             public HasTerms {
 public:
  ElasticInSpace(const Cage& cage, const CoordinateOptions& options, double nu, int level)
      : name_(cage.name()),
        nu_(nu),
        somigliana_(cage, coordinate_kind_named("somigliana"),
                    CoordinateOptions{options.evaluation, options.triangulation, {1, nu}}),
        evaluations_(3, options.evaluation),
        surface_(cage, somigliana_.elements(), level),
        blocks_{{.label = "E",
                 .owner = Owner::Vertex,
                 .size = static_cast<int>(somigliana_.elements().vertices().size()),
                 .shape = {.rows = 3, .columns = 3},
                 .reproduces = Reproduces::Vertices}} {
    require_range();
    require_room();
    prepared<double>();
    require_vertices_met(*this, blocks_[0], surface_.pieces, name_, "elastic", "displacements", 0.5);
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override {
    return std::min(evaluations_.displacement.max_order(), evaluations_.traction.max_order());
  }
  std::string evaluation() const override { return evaluations_.displacement.name(); }
  // Tractions are solved for in 50 digits at most.
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits100 && scalar != ScalarKind::Digits200 &&
           evaluations_.displacement.supports(scalar) && evaluations_.traction.supports(scalar);
  }
  bool is_prompt_in(ScalarKind scalar) const override {
    // In multiprecision a layer takes parts of a millisecond, and there is one per piece and centroid.
    return scalar == ScalarKind::Float || scalar == ScalarKind::Double || surface_.unknowns() <= 150;
  }
  const SolvesSystems* systems() const override { return this; }
  const HasLimits* limits() const override { return this; }
  const HasTerms* terms() const override { return this; }
  std::vector<SolvedSystem> solved() const override { return prepared<double>().described; }

  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    const auto make_sizes = [order](CoordinateTable<double>& table) {
      for (int o = 0; o <= order; ++o)
        for (double& x : table.tensors[o]) x = std::abs(x);
    };
    CoordinateTable<double> layers = kelvin_at<double>(points, order);
    make_sizes(layers);
    CoordinateTable<double> own{{}, tables[0].stride};
    for (const Vec3<double>& point : points) {
      const std::vector<Result<double>> terms = somigliana_.terms_at(point, order);
      for (int o = 0; o <= order; ++o)
        own.tensors[o].insert(own.tensors[o].end(), terms[0].of(o).begin(), terms[0].of(o).end());
    }
    put<double>(prepared<double>().tractions.cwiseAbs(), own, layers, points.size(), 0, order, tables[0]);
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
    constexpr std::size_t together = 32;  // tables of all pieces at so many points stay in the cache
    for (std::size_t first = 0; first < points.size(); first += together) {
      const auto some = points.subspan(first, std::min(together, points.size() - first));
      put<R>(prepared<R>().tractions, somigliana_.at<R>(some, order)[0], kelvin_at<R>(some, order), some.size(), first,
             order, tables[0]);
    }
  }

 private:
  template <Scalar R>
  struct Prepared {
    std::once_flag once;
    std::unique_ptr<ElasticSurfaceLayers<R>> layers;
    std::vector<SolvedSystem> described;
    Matrix<R> tractions;  // D transposed: a row a component of a vertex, a column one of a piece
  };

  void require_range() const {
    if (std::isfinite(surface_.pieces.unit())) return;
    throw InputError(
        name_ + ": no elastic coordinates: the cage's size leaves the range of double; take another unit of length");
  }

  void require_room() const {
    const double n = surface_.unknowns(), columns = 3. * blocks_[0].size;
    constexpr double matrices = 3, tables = 3;  // with factors and a copy; right sides, solutions and their transposes
    require_memory((matrices * n * n + tables * n * columns) * sizeof(double),
                   fmt::format("{}: an elastic system of {} unknowns and {} right sides", name_, n, columns),
                   "take a lower level or a cage of fewer faces");
  }

  template <Scalar R>
  const Prepared<R>& prepared() const {
    Prepared<R>& made = std::get<Prepared<R>>(prepared_);
    std::call_once(made.once, [&] {
      made.layers = std::make_unique<ElasticSurfaceLayers<R>>(surface_, evaluations_, nu_, blocks_[0].size);
      if constexpr (std::same_as<R, Mp100>) {
        made.tractions = prepared<Mp50>().tractions.template cast<R>();
      } else {
        // Somigliana's identity on the cage, from inside: K t = (H - T) u.
        const std::vector<PlaceOnTriangle> places = centroids(surface_.pieces);
        SquareSolution<R> solution =
            solve_square<R>("K t = (H - T) u, tractions from displacements", made.layers->displacement().rows(places),
                            missing_displacements<R>(*made.layers, places));
        made.tractions = solution.found.transpose();
        made.described = std::move(solution.described);
      }
    });
    return made;
  }

  // The hat functions at places, less the limits of their traction layer: three rows per place, three columns per
  // vertex.
  template <Scalar R>
  Matrix<R> missing_displacements(const ElasticSurfaceLayers<R>& layers,
                                  const std::vector<PlaceOnTriangle>& places) const {
    Matrix<R> found(static_cast<Eigen::Index>(3 * places.size()), 3 * blocks_[0].size);
    Eigen::Index row = 0;
    for (const PlaceOnTriangle& place : places) {
      const CoordinateTable<R> own = layers.traction_limit(place, 0);
      const R* from = own.tensors[0].data();
      Eigen::Matrix<R, 3, 3> sum = Eigen::Matrix<R, 3, 3>::Zero();
      for (Eigen::Index v = 0; v < blocks_[0].size; ++v)
        for (Eigen::Index i = 0; i < 3; ++i)
          for (Eigen::Index j = 0; j < 3; ++j) {
            sum(i, j) += *from;
            found(row + i, 3 * v + j) = -*from++;
          }
      require_identity(sum.template cast<double>(), place.triangle);
      const auto corners = surface_.pieces.vertices_of(place.triangle);
      const R second(place.second), third(place.third);
      for (Eigen::Index i = 0; i < 3; ++i) {
        found(row + i, 3 * corners[0] + i) += 1 - second - third;
        found(row + i, 3 * corners[1] + i) += second;
        found(row + i, 3 * corners[2] + i) += third;
      }
      row += 3;
    }
    return found;
  }

  void require_identity(const Eigen::Matrix3d& sum, int element) const {
    if (!sum.allFinite())
      throw InputError(
          fmt::format("{}: no elastic coordinates: on triangle {} (counted from 0, quads split) layers are not finite: "
                      "a face has no "
                      "area, or next to none; take it out",
                      name_, element));
    const double off = (sum - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (off <= 1e-6) return;
    throw InputError(fmt::format(
        "{}: no elastic coordinates: on triangle {} (counted from 0, quads split) Somigliana coordinates of vertices "
        "sum to a matrix that is {:.3g} off the identity: the cage overlaps itself, or is too thin there; make one "
        "surface of it (a union), or take mean_value",
        name_, element, off));
  }

  // Kelvin's displacements of all pieces.
  template <Scalar R>
  CoordinateTable<R> kelvin_at(std::span<const Vec3<R>> points, int order) const {
    return prepared<R>().layers->displacement().around(somigliana_.elements(), points, order);
  }

  template <Scalar R>
  void put_limits(std::span<const Touching> places, int order, CoordinateTable<R>& to) const {
    const Prepared<R>& known = prepared<R>();
    for (std::size_t p = 0; p < places.size(); ++p) {
      const PlaceOnTriangle place{places[p].element, places[p].basis[1], places[p].basis[2]};
      CoordinateTable<R> layers = known.layers->displacement().table(1, order);
      known.layers->displacement().add_on(
          RefinedSurface::at<R>(surface_.pieces.corners_of<R>(place.triangle), place.second, place.third),
          places.subspan(p, 1), order, layers);
      CoordinateTable<R> own = known.layers->traction_limit(place, order);
      // The limit is one of the frame.
      R unit = 1;
      for (int o = 0; o <= order; ++o, unit /= R(surface_.pieces.unit()))
        for (R& x : own.tensors[o]) x *= unit;
      put<R>(known.tractions, own, layers, 1, p, order, to);
    }
  }

  // Where points begin in the tables that are put in: at `first`.
  template <Scalar R>
  void put(const Matrix<R>& tractions, const CoordinateTable<R>& own, const CoordinateTable<R>& layers,
           std::size_t points, std::size_t first, int order, CoordinateTable<R>& table) const {
    R unit = 1;
    for (int o = 0; o <= order; ++o, unit /= R(surface_.pieces.unit())) {
      const std::size_t width = derivative_count(3, o), columns = 3 * width;
      // One row per component of a traction; columns are points' displacements, with their derivatives.
      Matrix<R> layer(surface_.unknowns(), static_cast<Eigen::Index>(points * columns));
      const R* from = layers.tensors[o].data();
      for (std::size_t p = 0; p < points; ++p)
        for (Eigen::Index piece = 0; piece < surface_.pieces.pieces(); ++piece)
          for (std::size_t i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < 3; ++j)
              for (std::size_t d = 0; d < width; ++d)
                layer(3 * piece + j, static_cast<Eigen::Index>(p * columns + i * width + d)) = *from++;
      const Matrix<R> sums = tractions * layer;
      const R* mine = own.tensors[o].data();
      for (std::size_t p = 0; p < points; ++p) {
        R* to = &table.tensors[o][(first + p) * table.stride[o]];
        for (Eigen::Index v = 0; v < blocks_[0].size; ++v)
          for (std::size_t i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < 3; ++j)
              for (std::size_t d = 0; d < width; ++d)
                *to++ = *mine++ + unit * sums(3 * v + j, static_cast<Eigen::Index>(p * columns + i * width + d));
      }
    }
  }

  std::string name_;
  double nu_;
  CageCoordinates somigliana_;
  ElasticEvaluations evaluations_;
  ElasticSurface surface_;
  std::vector<CoordinateBlock> blocks_;
  mutable std::tuple<Prepared<double>, Prepared<Mp50>, Prepared<Mp100>> prepared_;
};

}  // namespace

std::shared_ptr<const PreparedCoordinates> prepare_elastic_in_space(const Cage& cage, const CoordinateOptions& options,
                                                                    double nu, int level) {
  return std::make_shared<ElasticInSpace>(cage, options, nu, level);
}

std::string why_elastic_is_too_large(const Cage& cage) {
  return why_too_many_unknowns(cage, ElasticSurface::densities, default_elastic_level);
}

}  // namespace cageproof::solved
