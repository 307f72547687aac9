// SPDX-License-Identifier: MIT
#include "surface_layer.h"

#include "../boundary/touching.h"

#include "cageproof/core/numbers/linear.h"

#include <algorithm>

namespace cageproof::solved {
namespace {

// A triangle's plane: two directions in it, and the normal to the outside.
template <Scalar R>
std::array<Vec3<R>, 3> axes_of(const std::array<Vec3<R>, 3>& corners) {
  using std::sqrt;
  const auto unit = [](const Vec3<R>& v) { return Vec3<R>(v / R(sqrt(R(v.dot(v))))); };
  const Vec3<R> along = unit(corners[1] - corners[0]);
  const Vec3<R> normal = unit(along.cross(corners[2] - corners[0]));
  return {along, normal.cross(along), normal};
}

// Adds a tensor along the axes, in those of the space. Its indices have three values each, the last the fastest.
template <Scalar R>
void turn_in_space(const std::array<Vec3<R>, 3>& axes, int indices, std::span<const R> from, R* to) {
  std::vector<R> turned(from.begin(), from.end()), before;
  for (std::size_t step = 1; indices > 0; --indices, step *= 3) {
    before = turned;
    for (std::size_t k = 0; k < turned.size(); ++k) {
      const auto index = static_cast<Eigen::Index>(k / step % 3);
      const R* const first = &before[k - static_cast<std::size_t>(index) * step];
      turned[k] = axes[0][index] * first[0] + axes[1][index] * first[step] + axes[2][index] * first[2 * step];
    }
  }
  for (std::size_t k = 0; k < turned.size(); ++k) to[k] += turned[k];
}

}  // namespace

template <Scalar R>
SurfaceLayer<R>::SurfaceLayer(const RefinedSurface& surface, const Evaluation& evaluation,
                              std::span<const R> parameters)
    : surface_(surface),
      evaluation_(evaluation),
      parameters_(parameters.begin(), parameters.end()),
      slots_a_piece_(evaluation.formula().shape.per_corner ? 3 : 1) {
  for (int t = 0; t < surface_.triangles(); ++t) {
    const auto corners = surface_.corners_of<R>(t);
    for (int k = 0; k < surface_.pieces_a_triangle(); ++k) {
      const int first = (t * surface_.pieces_a_triangle() + k) * slots_a_piece_;
      pieces_.push_back({surface_.piece<R>(corners, k), {first, first + 1, first + 2}, t});
    }
  }
}

template <Scalar R>
CoordinateTable<R> SurfaceLayer<R>::table(std::size_t points, int order) const {
  CoordinateTable<R> made;
  for (int o = 0; o <= order; ++o) {
    made.stride[o] = static_cast<std::size_t>(slots()) * entries() * derivative_count(3, o);
    made.tensors[o].assign(points * made.stride[o], R(0));
  }
  return made;
}

template <Scalar R>
void SurfaceLayer<R>::add_piece(const Piece& piece, std::span<const Vec3<R>> points, int order,
                                CoordinateTable<R>& to) const {
  BatchOutput<R> output{.stride = to.stride,
                        .entries = static_cast<std::size_t>(entries()),
                        .dim = 3,
                        .slots = slots_of(piece),
                        .add = true};
  for (int o = 0; o <= order; ++o) output.tensors[o] = to.tensors[o].data();
  evaluation_(Batch<R>{piece.corners, points, order, parameters_}, output);
}

template <Scalar R>
void SurfaceLayer<R>::add(std::span<const Vec3<R>> points, int order, CoordinateTable<R>& to) const {
  for (const Piece& piece : pieces_) add_piece(piece, points, order, to);
}

template <Scalar R>
void SurfaceLayer<R>::add_in_plane(const Touching& on, int order, CoordinateTable<R>& to) const {
  const auto corners = surface_.corners_of<R>(on.element);
  const auto axes = axes_of<R>(corners);
  std::array<Vec3<R>, 3> flat;
  for (int c = 0; c < 3; ++c) {
    const Vec3<R> from_first = corners[c] - corners[0];
    flat[c] = Vec3<R>(from_first.dot(axes[0]), c == 2 ? from_first.dot(axes[1]) : R(0), R(0));
  }
  const Vec3<R> point = RefinedSurface::at<R>(flat, on.basis[1], on.basis[2]);
  const int own_indices = entries() == 9 ? 2 : 0;  // of a matrix, and of a number
  Result<R> found;
  for (int k = 0; k < surface_.pieces_a_triangle(); ++k) {
    const Piece& piece = pieces_[on.element * surface_.pieces_a_triangle() + k];
    evaluation_(Query<R>{surface_.piece<R>(flat, k), point, order, parameters_}, found);
    for (int c = 0; c < slots_a_piece_; ++c)
      for (int o = 0; o <= order; ++o) {
        const std::size_t width = static_cast<std::size_t>(entries()) * derivative_count(3, o);
        turn_in_space<R>(axes, own_indices + o, std::span<const R>(found.of(o)).subspan(c * width, width),
                         &to.tensors[o][piece.slots[c] * width]);
      }
  }
}

template <Scalar R>
void SurfaceLayer<R>::add_on(const Vec3<R>& point, std::span<const Touching> on, int order,
                             CoordinateTable<R>& to) const {
  for (const Piece& piece : pieces_)
    if (std::ranges::find(on, piece.triangle, &Touching::element) == on.end())
      add_piece(piece, std::span(&point, 1), order, to);
  for (const Touching& own : on) add_in_plane(own, order, to);
}

template <Scalar R>
CoordinateTable<R> SurfaceLayer<R>::around(const CageElements& elements, std::span<const Vec3<R>> points,
                                           int order) const {
  CoordinateTable<R> found = table(points.size(), order);
  std::vector<Vec3<R>> in_frame;
  bool touches = false;
  for (const Vec3<R>& point : points) {
    in_frame.push_back(surface_.in_frame<R>(point));
    touches = touches || (order > 0 && !touching(elements, point).empty());
  }
  // Values are continuous across the cage.
  if (!touches) {
    add(in_frame, order, found);
    return found;
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    CoordinateTable<R> one = table(1, order);
    const std::vector<Touching> on = touching(elements, points[p]);
    if (on.empty()) add(std::span(&in_frame[p], 1), order, one);
    else add_on(in_frame[p], on, order, one);
    for (int o = 0; o <= order; ++o) std::ranges::copy(one.tensors[o], &found.tensors[o][p * found.stride[o]]);
  }
  return found;
}

template <Scalar R>
Matrix<R> SurfaceLayer<R>::rows(std::span<const PlaceOnTriangle> places) const {
  constexpr std::size_t together = 64;  // tables of all slots at so many points stay in the cache
  const Shape& shape = evaluation_.formula().shape;
  Matrix<R> found(static_cast<Eigen::Index>(places.size()) * shape.rows,
                  static_cast<Eigen::Index>(slots()) * shape.columns);
  std::vector<Vec3<R>> points;
  for (std::size_t first = 0; first < places.size(); first += together) {
    points.clear();
    for (const PlaceOnTriangle& p : places.subspan(first, std::min(together, places.size() - first)))
      points.push_back(RefinedSurface::at<R>(surface_.corners_of<R>(p.triangle), p.second, p.third));
    CoordinateTable<R> values = table(points.size(), 0);
    add(points, 0, values);
    const R* from = values.tensors[0].data();
    for (std::size_t p = 0; p < points.size(); ++p)
      for (int slot = 0; slot < slots(); ++slot)
        for (int row = 0; row < shape.rows; ++row)
          for (int column = 0; column < shape.columns; ++column)
            found(static_cast<Eigen::Index>(first + p) * shape.rows + row, slot * shape.columns + column) = *from++;
  }
  return found;
}

template class SurfaceLayer<double>;
template class SurfaceLayer<Mp50>;
template class SurfaceLayer<Mp100>;

}  // namespace cageproof::solved
