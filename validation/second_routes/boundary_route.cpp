// SPDX-License-Identifier: MIT
#include "boundary_route.h"

#include "cageproof/core/numbers/linear.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::second_routes {
namespace {

constexpr int pieces_an_edge = 4;

using Numbers = Table<Mp200>;

Numbers least_squares_by_normal_equations(const Numbers& matrix, const Numbers& right) {
  NormalEquations<Mp200> squares(matrix.columns, right.columns);
  for (std::size_t r = 0; r < matrix.rows; ++r) {
    for (std::size_t k = 0; k < matrix.columns; ++k) squares.row(k) = matrix(r, k);
    for (std::size_t c = 0; c < right.columns; ++c) squares.value(c) = right(r, c);
    squares.add();
  }
  return squares.solution();
}

Numbers combined(Numbers a, const Numbers& b, int factor) {
  for (std::size_t k = 0; k < a.entries.size(); ++k) a.entries[k] += factor * b.entries[k];
  return a;
}

Numbers beside(const std::vector<Numbers>& parts) {
  std::size_t columns = 0;
  for (const Numbers& part : parts) columns += part.columns;
  Numbers all(parts.front().rows, columns);
  for (std::size_t r = 0; r < all.rows; ++r) {
    std::size_t c = 0;
    for (const Numbers& part : parts)
      for (std::size_t k = 0; k < part.columns; ++k) all(r, c++) = part(r, k);
  }
  return all;
}

}  // namespace

BoundaryRoute::BoundaryRoute(const Cage& cage, int order)
    : cage_(cage),
      order_(order),
      from_vertices_(cage.faces().size() * pieces_an_edge, cage.vertices().size()),
      from_edges_(from_vertices_.rows, cage.faces().size()) {
  for (const Vec3<double>& a : cage.vertices())
    for (const Vec3<double>& b : cage.vertices()) unit_ = std::max(unit_, (a - b).stableNorm());
  static constexpr std::array names{"segment.double_layer",
                                    "segment.single_layer",
                                    "segment.biharmonic_double_layer",
                                    "segment.biharmonic_single_layer",
                                    "segment.polyharmonic_double_layer",
                                    "segment.polyharmonic_single_layer"};
  for (int k = 0; k < 2 * order; ++k)
    of_layers_.push_back(EvaluationRegister::instance().with_role(names[k], Role::Recommended).value());
  for (std::size_t e = 0; e < cage.faces().size(); ++e)
    for (int k = 0; k < pieces_an_edge; ++k) {
      const std::size_t n = number_of(e, k);
      from_vertices_(n, cage.faces()[e].vertices[0]) = Mp200(pieces_an_edge - k) / pieces_an_edge;
      from_vertices_(n, cage.faces()[e].vertices[1]) += Mp200(k) / pieces_an_edge;
      from_edges_(n, e) = 1;
    }
  solve();
}

// Number of the node that lies k pieces along an edge, and of the piece that begins there.
std::size_t BoundaryRoute::number_of(std::size_t edge, int k) const {
  if (k < pieces_an_edge) return edge * pieces_an_edge + static_cast<std::size_t>(k);
  const int end = cage_.faces()[edge].vertices[1];
  std::size_t next = 0;
  while (cage_.faces()[next].vertices[0] != end) ++next;
  return next * pieces_an_edge;
}

Vec3<Mp50> BoundaryRoute::in_frame(const Vec3<double>& point) const {
  return (convert<Mp50>(point) - convert<Mp50>(cage_.vertices()[0])) / Mp50(unit_);
}

Vec3<Mp50> BoundaryRoute::node(std::size_t edge, int k) const {
  const Vec3<Mp50> from = in_frame(cage_.vertices()[cage_.faces()[edge].vertices[0]]),
                   to = in_frame(cage_.vertices()[cage_.faces()[edge].vertices[1]]);
  return (Mp50(pieces_an_edge - k) * from + Mp50(k) * to) / Mp50(pieces_an_edge);
}

// The cage lies on the left of its edges.
Vec3<Mp50> BoundaryRoute::inward(std::size_t edge) const {
  const Vec3<Mp50> along = node(edge, pieces_an_edge) - node(edge, 0);
  const Vec3<Mp50> left(-along[1], along[0], Mp50(0));
  return left / Mp50(sqrt(Mp50(left.dot(left))));
}

void BoundaryRoute::add_row(const Vec3<Mp50>& point, std::size_t row, Layers& layers) const {
  static const std::array<Mp50, 1> third{Mp50(3)};
  for (std::size_t e = 0; e < cage_.faces().size(); ++e)
    for (int k = 0; k < pieces_an_edge; ++k) {
      const std::array<Vec3<Mp50>, 2> ends{node(e, k), node(e, k + 1)};
      for (int o = 0; o < order_; ++o) {
        const std::span<const Mp50> parameters = o == 2 ? std::span<const Mp50>(third) : std::span<const Mp50>();
        Result<Mp50> of;
        of_layers_[2 * o](Query<Mp50>{ends, point, 0, parameters}, of);
        layers.phi[o](row, number_of(e, k)) += Mp200(of.value[0]);
        layers.phi[o](row, number_of(e, k + 1)) += Mp200(of.value[1]);
        of_layers_[2 * o + 1](Query<Mp50>{ends, point, 0, parameters}, of);
        layers.psi[o](row, number_of(e, k)) = Mp200(of.value[0]);
      }
    }
}

BoundaryRoute::Layers BoundaryRoute::layers_at(const std::vector<Vec3<Mp50>>& points) const {
  const std::vector<Matrix> empty(order_, Matrix(points.size(), from_vertices_.rows));
  Layers layers{empty, empty};
  for (std::size_t p = 0; p < points.size(); ++p) add_row(points[p], p, layers);
  return layers;
}

// The share of the second Laplacian that is held down, of a number that the method rounds to double: a tenth of the
// square of the longest edge, in diameters.
double BoundaryRoute::tau() const {
  double longest = 0;
  const auto at = [&](int v) { return Vec3<double>((cage_.vertices()[v] - cage_.vertices()[0]) / unit_); };
  for (const Face& edge : cage_.faces()) {
    const Vec3<double> along = at(edge.vertices[1]) - at(edge.vertices[0]);
    longest = std::max(longest, std::hypot(along[0], along[1]));
  }
  return longest * longest / 10;
}

void BoundaryRoute::solve() {
  // Identities are asked to hold so far inside of nodes and midpoints: layers are Hoelder continuous there.
  const Mp50 hair("1e-42");
  const std::size_t nodes = from_vertices_.rows;
  std::vector<Vec3<Mp50>> points;
  Matrix hats(2 * nodes, nodes);
  for (std::size_t e = 0; e < cage_.faces().size(); ++e)
    for (int k = 0; k < pieces_an_edge; ++k) {
      Vec3<Mp50> direction = inward(e);
      for (std::size_t before = 0; k == 0 && before < cage_.faces().size(); ++before)
        if (number_of(before, pieces_an_edge) == number_of(e, 0)) direction += inward(before);
      hats(points.size(), number_of(e, k)) = 1;
      points.push_back(node(e, k) + hair * direction);
      for (const int end : {k, k + 1}) hats(points.size(), number_of(e, end)) = 0.5;
      points.push_back((node(e, k) + node(e, k + 1)) / Mp50(2) + hair * inward(e));
    }
  const auto [phi, psi] = layers_at(points);
  const Matrix missing = combined(hats, phi[0], -1);
  // l = phi_1 l + psi_1 k, of the highest Laplacian.
  slopes_ = least_squares_by_normal_equations(psi[0], missing);
  if (order_ == 1) return;
  const Matrix second = combined(phi[1], product(psi[1], slopes_), 1);
  std::vector<Matrix> data{product(missing, from_vertices_),
                           combined(Matrix(points.size(), cage_.faces().size()), product(psi[0], from_edges_), -1)};
  if (order_ == 2) {
    highest_ = least_squares_by_normal_equations(second, beside(data));
    return;
  }
  lower_ = least_squares_by_normal_equations(psi[0], second);
  Matrix third = combined(combined(phi[2], product(psi[2], slopes_), 1), product(psi[1], lower_), -1);
  data.push_back(combined(Matrix(points.size(), from_vertices_.columns), product(second, from_vertices_), -1));
  // |K l - data|^2 + tau^2 |K|^2 |l|^2.
  Mp200 square = 0;
  for (const Mp200& x : third.entries) square += x * x;
  const Mp200 held = Mp200(tau()) * sqrt(square);
  Matrix right = beside(data);
  third.entries.resize((third.rows + nodes) * nodes, Mp200(0));
  right.entries.resize((right.rows + nodes) * right.columns, Mp200(0));
  for (std::size_t k = 0; k < nodes; ++k) third(third.rows + k, k) = held;
  third.rows = right.rows = third.rows + nodes;
  highest_ = least_squares_by_normal_equations(third, right);
}

std::vector<std::vector<Mp200>> BoundaryRoute::at(const Vec3<double>& point) const {
  const auto [phi, psi] = layers_at({in_frame(point)});
  const Mp200 unit = unit_;
  // f = phi_1 f + psi_1 d + phi_2 m + psi_2 (A m - E l) + phi_3 l + psi_3 A l, or the first of these.
  std::vector<Matrix> parts{product(phi[0], from_vertices_)};
  if (order_ == 1) parts[0] = combined(parts[0], product(psi[0], product(slopes_, from_vertices_)), 1);
  if (order_ > 1) {
    parts.push_back(product(psi[0], from_edges_));
    Matrix of_highest = combined(phi[order_ - 1], product(psi[order_ - 1], slopes_), 1);
    if (order_ == 3) {
      parts.push_back(product(combined(phi[1], product(psi[1], slopes_), 1), from_vertices_));
      of_highest = combined(of_highest, product(psi[1], lower_), -1);
    }
    const Matrix solved = product(of_highest, highest_);
    std::size_t first = 0;
    for (Matrix& part : parts)
      for (Mp200& x : part.entries) x += solved(0, first++);
  }
  std::vector<std::vector<Mp200>> blocks;
  Mp200 power = 1;
  for (const Matrix& part : parts) {
    std::vector<Mp200>& block = blocks.emplace_back(part.entries);
    for (Mp200& x : block) x *= power;
    power *= unit;
  }
  return blocks;
}

}  // namespace cageproof::second_routes
