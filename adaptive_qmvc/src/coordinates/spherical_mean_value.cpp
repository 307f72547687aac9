// SPDX-License-Identifier: MIT
// Spherical mean value coordinates (Langer, Belyaev, Seidel 2006; [T18] Section 5).
#include "spherical_derivatives.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace cageproof::adaptive_qmvc {
namespace {

// Sizes of elements' weights over those of the vertices', and the same of weights times how far the point would move if
// its vertex drew it, over what coordinates times positions add up to: beyond this, double loses more than a few
// roundings.
constexpr double kMostTerms = 4;

class SphericalCoordinates final : public CoordinatesInDouble<SphericalCoordinates> {
 public:
  explicit SphericalCoordinates(const Cage& cage)
      : elements_(cage, true, Triangulation::Shortest),
        triangle_(*EvaluationRegister::instance().with_role("triangle.mean_value", Role::Recommended)),
        vertices_(elements_.vertices()) {
    double largest = 0;
    for (const Vec3<double>& v : vertices_) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    // Other cages are in their own unit, in which the least numbers are not lost.
    constexpr int kComfortable = 40;
    if (largest > 0 && std::abs(std::ilogb(largest)) > kComfortable) exponent_ = std::ilogb(largest);
    for (Vec3<double>& v : vertices_) v = in_unit(v);
    blocks_.push_back({.label = "lambda",
                       .owner = Owner::Vertex,
                       .size = static_cast<int>(elements_.vertices().size()),
                       .shape = {},
                       .reproduces = Reproduces::Vertices});
  }
  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return 2; }
  std::string evaluation() const override { return triangle_.name(); }
  bool is_exact_in(ScalarKind scalar) const override { return scalar != ScalarKind::Digits200; }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!put_limit(points[p], p, order, tables[0])) {
        if (order == 0) put<R>(points[p], p, order, tables[0]);
        else put<SecondOrder<R>>(points[p], p, order, tables[0]);
      }
    }
  }

 private:
  // Sets coordinates of a point on the cage: hat functions, linear on borders, mean value coordinates within planar
  // quads. Returns false off the cage, and within other quads, which have no such limit, so that coordinates are as
  // elsewhere. Points that are no doubles are treated as off the cage.
  template <Scalar R>
  bool put_limit(const Vec3<R>& eta, std::size_t point, int order, CoordinateTable<R>& table) const {
    const Vec3<double> rounded = convert<double>(eta);
    if (convert<R>(rounded) != eta) return false;
    for (const Touching& touch : elements_.touching(rounded))
      if (const auto on = limit<R>(touch, rounded)) {
        const auto vertices = elements_.vertices_of(touch.element);
        for (std::size_t k = 0; k < vertices.size(); ++k)
          table.tensors[0][point * table.stride[0] + vertices[k]] += (*on)[k];
        for (int o = 1; o <= order; ++o)
          std::fill_n(table.tensors[o].begin() + static_cast<std::ptrdiff_t>(point * table.stride[o]), table.stride[o],
                      std::numeric_limits<R>::quiet_NaN());
        return true;
      }
    return false;
  }

  template <Scalar R>
  std::optional<std::array<R, 4>> limit(const Touching& touch, const Vec3<double>& eta) const {
    const std::array<double, 4>& b = touch.basis;
    if (elements_.type(touch.element).kind == ElementKind::Triangle || std::ranges::count(b, 0.0) >= 2)
      return std::array<R, 4>{R(b[0]), R(b[1]), R(b[2]), R(b[3])};
    const Quad<double> q = quad(touch.element);
    if (!is_planar(q)) return std::nullopt;
    return planar_coordinates<R>({convert<R>(q[0]), convert<R>(q[1]), convert<R>(q[2]), convert<R>(q[3])},
                                 in_unit(convert<R>(eta)));
  }

  // The sum over all elements, divided by its total, in a unit in which no product leaves the scalar's range. In
  // double, where distances are so unlike that products do, values come from 200 digits.
  template <class N, Scalar R>
  void put(const Vec3<R>& eta, std::size_t point, int order, CoordinateTable<R>& table) const {
    const Vec3<R> scaled = in_unit(eta);
    auto [found, terms] = sum<N>(scaled, order);
    bool beyond_range = false;
    if constexpr (std::same_as<N, double>) {
      beyond_range =
          has_distant_exponents(scaled) || std::ranges::any_of(found, [](double x) { return !std::isfinite(x); });
      if (beyond_range)
        std::ranges::transform(sum<Mp200>(in_unit(convert<Mp200>(eta)), order).coordinates, found.begin(),
                               [](const Mp200& x) { return static_cast<double>(x); });
    }
    if constexpr (std::same_as<R, double>)
      if (!beyond_range && terms > kMostTerms) return put_in_more_digits(eta, point, order, table);
    for (std::size_t v = 0; v < found.size(); ++v) store<N>(found[v], v, point, order, table);
    using std::ldexp;
    for (int o = 1; o <= order; ++o)
      for (R& x : std::span(table.tensors[o]).subspan(point * table.stride[o], table.stride[o]))
        x = ldexp(x, -o * exponent_);
  }

  // Both sides of a thin wall give its vertices weights of opposite signs outside: in double their sums would be those
  // terms' roundings.
  void put_in_more_digits(const Vec3<double>& eta, std::size_t point, int order, CoordinateTable<double>& table) const {
    auto wide = zero_tables<Mp50>(blocks_, 3, 1, order);
    if (order == 0) put<Mp50>(convert<Mp50>(eta), 0, order, wide[0]);
    else put<SecondOrder<Mp50>>(convert<Mp50>(eta), 0, order, wide[0]);
    for (int o = 0; o <= order; ++o)
      std::ranges::transform(wide[0].tensors[o],
                             table.tensors[o].begin() + static_cast<std::ptrdiff_t>(point * table.stride[o]),
                             [](const Mp50& x) { return static_cast<double>(x); });
  }

  template <Scalar R>
  Vec3<R> in_unit(const Vec3<R>& p) const {
    using std::ldexp;
    return {ldexp(p[0], -exponent_), ldexp(p[1], -exponent_), ldexp(p[2], -exponent_)};
  }

  // Whether the point is nearer to a plane of the axes through a vertex than double's products of four such distances
  // can say beside those of the cage's size. \param eta in the unit
  bool has_distant_exponents(const Vec3<double>& eta) const {
    constexpr double kNear = 0x1p-40;
    return std::ranges::any_of(vertices_, [&](const Vec3<double>& v) {
      const auto apart = (v - eta).cwiseAbs().array();
      return ((apart > 0) && (apart < kNear)).any();
    });
  }

  template <class N>
  struct Sum {
    std::vector<N> coordinates;
    double terms;  // as kMostTerms says
  };

  template <class N, Scalar R>
  Sum<N> sum(const Vec3<R>& eta, int order) const {
    std::vector<N> found(elements_.vertices().size(), N(R(0)));
    R terms(0), sums(0), moves(0), positions(0);
    const auto add = [&](int vertex, const N& weight) {
      using std::abs;
      found[vertex] += weight;
      terms += abs(value_of(weight));
      moves += abs(value_of(weight)) * Vec3<R>(convert<R>(vertices_[vertex]) - eta).norm();
    };
    Result<R> of_triangle;
    for (std::size_t e = 0; e < elements_.count(); ++e) {
      const auto vertices = elements_.vertices_of(e);
      if (elements_.type(e).kind == ElementKind::Quad) {
        const CornerWeights<N> weights = quad_weights<N>(quad(e), eta);
        for (std::size_t k = 0; k < 4; ++k) add(vertices[k], weights[k]);
      } else {
        // Three directions leave no choice: the coordinates are those of triangles.
        std::array<Vec3<R>, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = convert<R>(vertices_[vertices[k]]);
        triangle_(Query<R>{corners, eta, order, {}}, of_triangle);
        for (std::size_t k = 0; k < 3; ++k) add(vertices[k], number<N>(of_triangle, order, k));
      }
    }
    N total(R(0));
    for (std::size_t v = 0; v < found.size(); ++v) {
      using std::abs;
      total += found[v];
      sums += abs(value_of(found[v]));
      positions += abs(value_of(found[v])) * R(vertices_[v].norm());
    }
    for (N& w : found) w /= total;
    return {std::move(found), static_cast<double>(std::max(R(terms / sums), R(moves / positions)))};
  }

  template <class N, Scalar R>
  static CornerWeights<N> quad_weights(const Quad<double>& q, const Vec3<R>& eta) {
    if constexpr (std::same_as<N, R>)
      return SphericalQuad<R>({convert<R>(q[0]), convert<R>(q[1]), convert<R>(q[2]), convert<R>(q[3])}, eta).weights;
    else return spherical_weights<R>(q, eta);
  }

  // Entry k of a result, with its derivatives up to `order`.
  template <class N, Scalar R>
  static N number(const Result<R>& result, int order, std::size_t k) {
    N x(result.value[k]);
    if constexpr (!std::same_as<N, R>)
      for (std::size_t i = 0; i < 3; ++i) {
        x.gradient[i] = result.gradient[3 * k + i];
        for (std::size_t j = i; order >= 2 && j < 3; ++j) x.hessian[N::entry(i, j)] = result.hessian[9 * k + 3 * i + j];
      }
    return x;
  }

  template <class N, Scalar R>
  static void store(const N& x, std::size_t vertex, std::size_t point, int order, CoordinateTable<R>& table) {
    const auto at = [&](int o) { return &table.tensors[o][point * table.stride[o] + vertex * derivative_count(3, o)]; };
    *at(0) = value_of(x);
    if constexpr (!std::same_as<N, R>) {
      std::ranges::copy(x.gradient, at(1));
      if (order < 2) return;
      R* const hessian = at(2);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) hessian[3 * i + j] = x.hessian[N::entry(i, j)];
    }
  }

  Quad<double> quad(std::size_t e) const {
    const auto vertices = elements_.vertices_of(e);
    return {vertices_[vertices[0]], vertices_[vertices[1]], vertices_[vertices[2]], vertices_[vertices[3]]};
  }

  CageElements elements_;
  Evaluation triangle_;
  int exponent_ = 0;
  std::vector<Vec3<double>> vertices_;  // in units of 2^exponent
  std::vector<CoordinateBlock> blocks_;
};

std::shared_ptr<const PreparedCoordinates> prepare_spherical(const Cage& cage, const CoordinateOptions& options) {
  auto coordinates = std::make_shared<SphericalCoordinates>(cage);
  const std::string only = coordinates->evaluation();
  if (!options.evaluation.empty() && options.evaluation != only)
    throw InputError(fmt::format("spherical_mean_value has no evaluation '{}', only {}", options.evaluation, only));
  return coordinates;
}

const RegisterCoordinateKind register_spherical_mean_value{{.name = "spherical_mean_value",
                                                            .source = "Langer, Belyaev, Seidel 2006; [T18] Section 5",
                                                            .normalised = true,
                                                            .keeps_quads = true,
                                                            .prepare = prepare_spherical}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
