// SPDX-License-Identifier: MIT
#include "boundary_layers.h"

#include "cageproof/core/input_error.h"

#include <algorithm>
#include <string_view>

namespace cageproof::solved {
namespace {

constexpr std::array<std::string_view, 6> formulas{"segment.double_layer",
                                                   "segment.single_layer",
                                                   "segment.biharmonic_double_layer",
                                                   "segment.biharmonic_single_layer",
                                                   "segment.polyharmonic_double_layer",
                                                   "segment.polyharmonic_single_layer"};

// Parameters of the layers' formulas; only those of order 3 have any.
template <Scalar R>
std::span<const R> parameters_of(Layer layer) {
  static const std::array<R, 1> order{R(3)};
  if (layer == Layer::TriharmonicDouble || layer == Layer::TriharmonicSingle) return order;
  return {};
}

// Derivatives of a number along a line and to its left, in the axes of the plane.
template <Scalar R>
void turn(const typename RefinedPolygon::Line<R>& line, int order, const R* from, R* to) {
  if (order == 0) {
    to[0] += from[0];
    return;
  }
  const std::array<Vec3<R>, 2> axes{line.direction, line.left()};
  for (int a = 0; a < 2; ++a) {
    if (order == 1) {
      to[a] += axes[0][a] * from[0] + axes[1][a] * from[1];
      continue;
    }
    for (int b = 0; b < 2; ++b) {
      R sum = 0;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) sum += axes[i][a] * axes[j][b] * from[2 * i + j];
      to[2 * a + b] += sum;
    }
  }
}

template <Scalar R>
Eigen::Matrix<R, 1, Eigen::Dynamic> row_of(const CoordinateTable<R>& table) {
  return Eigen::Map<const Eigen::Matrix<R, 1, Eigen::Dynamic>>(table.tensors[0].data(), table.tensors[0].size());
}

}  // namespace

LayerEvaluations layer_evaluations(const std::string& name, int order) {
  LayerEvaluations found;
  for (const std::string_view formula : std::span(formulas).first(2 * order))
    found.push_back(name.empty() ? EvaluationRegister::instance().with_role(formula, Role::Recommended).value()
                                 : evaluation_named(formula, name));
  return found;
}

template <Scalar R>
BoundaryLayers<R>::BoundaryLayers(const RefinedPolygon& polygon, const LayerEvaluations& evaluations)
    : polygon_(polygon), evaluations_(evaluations) {
  for (int e = 0; e < polygon_.edges(); ++e)
    for (int k = 0; k < polygon_.pieces_an_edge(); ++k) pieces_.push_back(piece(e, k));
}

template <Scalar R>
typename BoundaryLayers<R>::Piece BoundaryLayers<R>::piece(int edge, int part) const {
  const int from = polygon_.seer(edge, part);
  return {from,
          {polygon_.along<R>(edge, R(part), from), polygon_.along<R>(edge, R(part + 1), from)},
          {polygon_.node(edge, part), polygon_.node(edge, part + 1)},
          edge * polygon_.pieces_an_edge() + part};
}

template <Scalar R>
CoordinateTable<R> BoundaryLayers<R>::table(Layer layer, std::size_t points, int order) const {
  CoordinateTable<R> made;
  for (int o = 0; o <= order; ++o) {
    made.stride[o] = (is_per_node(layer) ? polygon_.nodes() : polygon_.pieces()) * derivative_count(2, o);
    made.tensors[o].assign(points * made.stride[o], R(0));
  }
  return made;
}

template <Scalar R>
void BoundaryLayers<R>::add_piece(const Piece& piece, std::span<const Layer> layers, std::span<const Vec3<R>> points,
                                  int order, std::span<CoordinateTable<R>> tables) const {
  std::array<const Evaluation*, all_layers.size()> members{};
  std::array<BatchOutput<R>, all_layers.size()> outputs;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    members[k] = &evaluations_[static_cast<std::size_t>(layers[k])];
    outputs[k] = {.stride = tables[k].stride, .dim = 2, .add = true};
    outputs[k].slots = is_per_node(layers[k]) ? std::span<const int>(piece.nodes) : std::span(&piece.number, 1);
    for (int o = 0; o <= order; ++o) outputs[k].tensors[o] = tables[k].tensors[o].data();
  }
  // Layers with the same parameters are computed together.
  for (std::size_t first = 0, end = 0; first < layers.size(); first = end) {
    const std::span<const R> parameters = parameters_of<R>(layers[first]);
    while (end < layers.size() && std::ranges::equal(parameters_of<R>(layers[end]), parameters)) ++end;
    Evaluation::together<R>(std::span(members).subspan(first, end - first),
                            Batch<R>{piece.ends, points, order, parameters},
                            std::span(outputs).subspan(first, end - first));
  }
}

template <Scalar R>
std::vector<Vec3<R>> BoundaryLayers<R>::seen_from(int vertex, std::span<const At> points) const {
  std::vector<Vec3<R>> seen;
  seen.reserve(points.size());
  for (const At& point : points) seen.push_back(polygon_.seen_from<R>(vertex, point));
  return seen;
}

template <Scalar R>
void BoundaryLayers<R>::add(std::span<const Layer> layers, std::span<const At> points, int order,
                            std::span<CoordinateTable<R>> tables) const {
  std::vector<Vec3<R>> seen;
  int from = -1;
  for (const Piece& piece : pieces_) {
    if (piece.seen_from != from) seen = seen_from(from = piece.seen_from, points);
    add_piece(piece, layers, seen, order, tables);
  }
}

template <Scalar R>
void BoundaryLayers<R>::add_in_line(int edge, const R& steps, std::span<const Layer> layers, int order,
                                    std::span<CoordinateTable<R>> tables) const {
  const auto line = polygon_.line<R>(edge);
  const auto along = [&](const R& s) { return Vec3<R>(R(s * line.piece), R(0), R(0)); };
  Result<R> found;
  for (int k = 0; k < polygon_.pieces_an_edge(); ++k) {
    const std::array<Vec3<R>, 2> ends{along(R(k)), along(R(k + 1))};
    for (std::size_t l = 0; l < layers.size(); ++l) {
      evaluations_[static_cast<std::size_t>(layers[l])](
          Query<R>{ends, along(steps), order, parameters_of<R>(layers[l])}, found);
      const bool per_node = is_per_node(layers[l]);
      for (int c = 0; c < (per_node ? 2 : 1); ++c)
        for (int o = 0; o <= order; ++o) {
          const std::size_t width = derivative_count(2, o);
          const std::size_t slot = per_node ? polygon_.node(edge, k + c) : edge * polygon_.pieces_an_edge() + k;
          turn<R>(line, o, &found.of(o)[c * width], &tables[l].tensors[o][slot * width]);
        }
    }
  }
}

template <Scalar R>
void BoundaryLayers<R>::add_others(std::span<const Layer> layers, const At& point, std::span<const OnEdge<R>> on,
                                   int order, std::span<CoordinateTable<R>> tables) const {
  for (const Piece& piece : pieces_)
    if (std::ranges::find(on, piece.number / polygon_.pieces_an_edge(), &OnEdge<R>::edge) == on.end())
      add_piece(piece, layers, seen_from(piece.seen_from, std::span(&point, 1)), order, tables);
}

template <Scalar R>
void BoundaryLayers<R>::add_on(std::span<const Layer> layers, const At& point, std::span<const OnEdge<R>> on, int order,
                               std::span<CoordinateTable<R>> tables) const {
  add_others(layers, point, on, order, tables);
  for (const OnEdge<R>& own : on) add_in_line(own.edge, own.steps, layers, order, tables);
}

template <Scalar R>
std::vector<CoordinateTable<R>> BoundaryLayers<R>::tables() const {
  std::vector<CoordinateTable<R>> made;
  made.reserve(evaluations_.size());
  for (const Layer layer : layers()) made.push_back(table(layer, 1, 0));
  return made;
}

template <Scalar R>
LayerRows<R> BoundaryLayers<R>::rows(std::span<const CollocationPoint> points, double inset) const {
  const auto count = static_cast<Eigen::Index>(points.size());
  LayerRows<R> found;
  found.hats = Matrix<R>::Zero(count, polygon_.nodes());
  for (const Layer layer : layers())
    found.layer.push_back(Matrix<R>::Zero(count, is_per_node(layer) ? polygon_.nodes() : polygon_.pieces()));
  for (Eigen::Index row = 0; row < count; ++row) {
    const CollocationPoint& p = points[row];
    found.hats(row, polygon_.node(p.edge, p.piece)) += R(p.parts - p.part) / p.parts;
    if (p.part != 0) found.hats(row, polygon_.node(p.edge, p.piece + 1)) += R(p.part) / p.parts;
    if (inset == 0) put_limits(p, row, found);
    else put_inset(p, inset, row, found);
  }
  return found;
}

template <Scalar R>
void BoundaryLayers<R>::put_limits(const CollocationPoint& p, Eigen::Index row, LayerRows<R>& rows) const {
  std::vector<OnEdge<R>> on{{p.edge, R(p.piece) + R(p.part) / p.parts}};
  if (p.is_vertex()) on.push_back({polygon_.before(p.edge), R(polygon_.pieces_an_edge())});
  std::vector<CoordinateTable<R>> found = tables();
  add_others(layers(), polygon_.on<R>(p.edge, on[0].steps), on, 0, found);
  for (const OnEdge<R>& own : on) add_in_line(own.edge, own.steps, layers().subspan(1), 0, std::span(found).subspan(1));
  R left = 1;
  for (const R& x : found[0].tensors[0]) left -= x;
  for (std::size_t k = 0; k < found.size(); ++k) rows.layer[k].row(row) = row_of(found[k]);
  rows.layer[0].row(row) += left * rows.hats.row(row);
}

template <Scalar R>
typename BoundaryLayers<R>::At BoundaryLayers<R>::inset_node(int edge, int k, const R& inset) const {
  const int other = k == 0 ? polygon_.before(edge) : k == polygon_.pieces_an_edge() ? polygon_.after(edge) : edge;
  const Vec3<R> one = polygon_.line<R>(edge).left(), two = polygon_.line<R>(other).left();
  // Where the lines that are offset from both edges cross.
  At at = polygon_.on<R>(edge, R(k));
  at.step += inset / (1 + one.dot(two)) * (one + two);
  return at;
}

template <Scalar R>
void BoundaryLayers<R>::put_inset(const CollocationPoint& p, double inset, Eigen::Index row, LayerRows<R>& rows) const {
  const int seer = polygon_.seer(p.edge, p.piece);
  const Vec3<R> from = polygon_.seen_from<R>(seer, inset_node(p.edge, p.piece, R(inset))),
                to = polygon_.seen_from<R>(seer, inset_node(p.edge, p.piece + 1, R(inset)));
  const At at{polygon_.vertex<R>(seer), from + R(p.part) / p.parts * (to - from)};
  std::vector<CoordinateTable<R>> found = tables();
  add(layers(), std::span(&at, 1), 0, found);
  for (std::size_t k = 0; k < found.size(); ++k) rows.layer[k].row(row) = row_of(found[k]);
}

template class BoundaryLayers<double>;
template class BoundaryLayers<Mp50>;
template class BoundaryLayers<Mp100>;

}  // namespace cageproof::solved
