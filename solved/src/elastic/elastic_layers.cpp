// SPDX-License-Identifier: MIT
#include "elastic_layers.h"

#include <algorithm>

namespace cageproof::solved {
namespace {

Evaluation named_or_recommended(std::string_view formula, const std::string& name) {
  return name.empty() ? EvaluationRegister::instance().with_role(formula, Role::Recommended).value()
                      : evaluation_named(formula, name);
}

// A tensor of the plane along a line and to its left, in the plane's axes; its indices are bits of a number, the last
// the lowest.
template <Scalar R>
void turn_tensor(const typename RefinedPolygon::Line<R>& line, int indices, const R* from, R* to) {
  const std::array<Vec3<R>, 2> axes{line.direction, line.left()};
  for (int out = 0; out < 1 << indices; ++out) {
    R sum = 0;
    for (int in = 0; in < 1 << indices; ++in) {
      R term = from[in];
      for (int k = 0; k < indices; ++k) term *= axes[in >> k & 1][out >> k & 1];
      sum += term;
    }
    to[out] += sum;
  }
}

template <Scalar R>
bool is_on(std::span<const OnEdge<R>> on, int edge) {
  return std::ranges::find(on, edge, &OnEdge<R>::edge) != on.end();
}

}  // namespace

ElasticEvaluations::ElasticEvaluations(int dimension, const std::string& name)
    : displacement(
          named_or_recommended(dimension == 2 ? "segment.kelvin_displacement" : "triangle.kelvin_displacement", name)),
      traction(named_or_recommended(dimension == 2 ? "segment.kelvin_traction" : "triangle.kelvin_traction", name)) {}

template <Scalar R>
ElasticLayers<R>::ElasticLayers(const RefinedPolygon& polygon, const ElasticEvaluations& evaluations, double nu)
    : polygon_(polygon), evaluations_(evaluations), parameters_{R(1), R(nu)} {}

template <Scalar R>
CoordinateTable<R> ElasticLayers<R>::table(std::size_t points, int order) const {
  CoordinateTable<R> made;
  for (int o = 0; o <= order; ++o) {
    made.stride[o] = 4 * polygon_.pieces() * derivative_count(2, o);
    made.tensors[o].assign(points * made.stride[o], R(0));
  }
  return made;
}

template <Scalar R>
void ElasticLayers<R>::add_pieces(int edge, std::span<const At> points, int order, CoordinateTable<R>& table) const {
  BatchOutput<R> output{.stride = table.stride, .entries = 4, .dim = 2, .add = true};
  for (int o = 0; o <= order; ++o) output.tensors[o] = table.tensors[o].data();
  std::vector<Vec3<R>> seen;
  int from = -1;
  for (int k = 0; k < polygon_.pieces_an_edge(); ++k) {
    if (const int seer = polygon_.seer(edge, k); seer != from) {
      from = seer;
      seen.clear();
      for (const At& point : points) seen.push_back(polygon_.seen_from<R>(from, point));
    }
    const std::array<Vec3<R>, 2> ends{polygon_.along<R>(edge, R(k), from), polygon_.along<R>(edge, R(k + 1), from)};
    const int piece = edge * polygon_.pieces_an_edge() + k;
    output.slots = std::span(&piece, 1);
    evaluations_.displacement(Batch<R>{ends, seen, order, parameters_}, output);
  }
}

template <Scalar R>
void ElasticLayers<R>::add_pieces_in_line(const OnEdge<R>& on, int order, CoordinateTable<R>& table) const {
  const auto line = polygon_.line<R>(on.edge);
  const auto along = [&](const R& steps) { return Vec3<R>(R(steps * line.piece), R(0), R(0)); };
  Result<R> found;
  for (int k = 0; k < polygon_.pieces_an_edge(); ++k) {
    const std::array<Vec3<R>, 2> ends{along(R(k)), along(R(k + 1))};
    evaluations_.displacement(Query<R>{ends, along(on.steps), order, parameters_}, found);
    const std::size_t piece = on.edge * polygon_.pieces_an_edge() + k;
    for (int o = 0; o <= order; ++o)
      turn_tensor<R>(line, 2 + o, found.of(o).data(), &table.tensors[o][4 * piece * derivative_count(2, o)]);
  }
}

template <Scalar R>
void ElasticLayers<R>::add(std::span<const At> points, int order, CoordinateTable<R>& table) const {
  for (int e = 0; e < polygon_.edges(); ++e) add_pieces(e, points, order, table);
}

template <Scalar R>
void ElasticLayers<R>::add_on(const At& point, std::span<const OnEdge<R>> on, int order,
                              CoordinateTable<R>& table) const {
  for (int e = 0; e < polygon_.edges(); ++e)
    if (!is_on(on, e)) add_pieces(e, std::span(&point, 1), order, table);
  for (const OnEdge<R>& own : on) add_pieces_in_line(own, order, table);
}

template <Scalar R>
std::array<typename ElasticLayers<R>::Matrix2, 2> ElasticLayers<R>::tractions(std::span<const Vec3<R>> ends,
                                                                              const Vec3<R>& point) const {
  Result<R> found;
  evaluations_.traction(Query<R>{ends, point, 0, parameters_, true}, found);
  std::array<Matrix2, 2> matrices;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 4; ++i) matrices[k](i / 2, i % 2) = found.value[4 * k + i];
  return matrices;
}

// The factor of an edge's end displacements, less the displacement at a point on the edge. Their integral exists at
// ends, too, where that of either diverges. The factor is this for the second end, and minus this for the first.
template <Scalar R>
typename ElasticLayers<R>::Matrix2 ElasticLayers<R>::pull_to_end(const OnEdge<R>& on) const {
  const auto line = polygon_.line<R>(on.edge);
  const R last(polygon_.pieces_an_edge());
  const std::array<Vec3<R>, 2> ends{Vec3<R>::Zero(), Vec3<R>(R(last * line.piece), R(0), R(0))};
  const auto [first, second] = tractions(ends, on.steps == last ? ends[1] : Vec3<R>(R(on.steps * line.piece), 0, 0));
  Matrix2 in_line = second;
  if (on.steps == last) in_line = -first;
  else if (on.steps != 0) in_line = (1 - on.steps / last) * second - on.steps / last * first;
  std::array<R, 4> turned{};
  const std::array<R, 4> entries{in_line(0, 0), in_line(0, 1), in_line(1, 0), in_line(1, 1)};
  turn_tensor<R>(line, 2, entries.data(), turned.data());
  return Matrix2{{turned[0], turned[1]}, {turned[2], turned[3]}};
}

// The place that a whole edge sees a point from: the nearer of its ends where the polygon has a short edge, as pieces
// do.
template <Scalar R>
int ElasticLayers<R>::seer_of(int edge, const At& point) const {
  if (!polygon_.has_short_edge()) return polygon_.seer(edge, 0);
  const auto [first, second] = polygon_.edge(edge);
  return polygon_.seen_from<R>(first, point).squaredNorm() <= polygon_.seen_from<R>(second, point).squaredNorm()
             ? first
             : second;
}

// (H - T) u = -int T(u - u at the point): shares of the vertices that the point lies between cancel, except for those
// of edges that it is not on.
template <Scalar R>
void ElasticLayers<R>::put_data(const std::vector<OnEdge<R>>& on, const At& point, Eigen::Index row,
                                Matrix<R>& data) const {
  const auto add = [&](int vertex, const Matrix2& matrix) { data.template block<2, 2>(row, 2 * vertex) += matrix; };
  const R second = on[0].steps / polygon_.pieces_an_edge();
  const std::array<int, 2>& between = polygon_.edge(on[0].edge);
  for (int e = 0; e < polygon_.edges(); ++e) {
    if (is_on(std::span<const OnEdge<R>>(on), e)) continue;
    const int from = seer_of(e, point);
    const std::array<Vec3<R>, 2> ends{polygon_.along<R>(e, R(0), from),
                                      polygon_.along<R>(e, R(polygon_.pieces_an_edge()), from)};
    const std::array<Matrix2, 2> of_ends = tractions(ends, polygon_.seen_from<R>(from, point));
    const Matrix2 whole = of_ends[0] + of_ends[1];
    for (int k = 0; k < 2; ++k) add(polygon_.edge(e)[k], -of_ends[k]);
    add(between[0], (1 - second) * whole);
    if (second != 0) add(between[1], second * whole);
  }
  for (const OnEdge<R>& own : on) {
    const Matrix2 pull = pull_to_end(own);
    add(polygon_.edge(own.edge)[1], -pull);
    add(polygon_.edge(own.edge)[0], pull);
  }
}

template <Scalar R>
typename ElasticLayers<R>::Equations ElasticLayers<R>::equations(std::span<const CollocationPoint> points) const {
  const auto rows = static_cast<Eigen::Index>(2 * points.size());
  Equations found{Matrix<R>::Zero(rows, 2 * polygon_.pieces()), Matrix<R>::Zero(rows, 2 * polygon_.vertices())};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CollocationPoint& p = points[k];
    const auto row = static_cast<Eigen::Index>(2 * k);
    std::vector<OnEdge<R>> on{{p.edge, R(p.piece) + R(p.part) / p.parts}};
    if (p.is_vertex()) on.push_back({polygon_.before(p.edge), R(polygon_.pieces_an_edge())});
    const At at = polygon_.on<R>(p.edge, on[0].steps);
    CoordinateTable<R> layers = table(1, 0);
    add_on(at, on, 0, layers);
    for (Eigen::Index piece = 0; piece < polygon_.pieces(); ++piece)
      for (int i = 0; i < 4; ++i) found.displacement(row + i / 2, 2 * piece + i % 2) = layers.tensors[0][4 * piece + i];
    put_data(on, at, row, found.data);
  }
  return found;
}

template class ElasticLayers<double>;
template class ElasticLayers<Mp50>;
template class ElasticLayers<Mp100>;

}  // namespace cageproof::solved
