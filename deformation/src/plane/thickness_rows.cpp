// SPDX-License-Identifier: MIT
#include "thickness_rows.h"

#include "../constraint_checks.h"
#include "../layers/samples.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {

template <Scalar R>
BoundaryRows<R> thickness_rows(const CageCoordinates& coordinates, int samples_an_edge) {
  const CageElements& elements = coordinates.elements();
  std::vector<Touching> samples;
  samples.reserve(elements.count() * static_cast<std::size_t>(samples_an_edge));
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (int q = 0; q < samples_an_edge; ++q) {
      const double along = (q + 0.5) / samples_an_edge;
      samples.push_back({static_cast<int>(e), {1 - along, along, 0, 0}});
    }
  const auto tables = coordinates.limits_at<R>(samples, 2);
  const auto count = static_cast<Eigen::Index>(samples.size());
  BoundaryRows<R> rows{Matrix<R>::Zero(count, coordinates.blocks()[0].size),
                       Matrix<R>::Zero(count, coordinates.blocks()[1].size)};
  for (std::size_t b = 0; b < 2; ++b) {
    Matrix<R>& into = b == 0 ? rows.of_vertices : rows.of_normals;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const Matrix<R> along = component(tables[b], samples.size(), 2, 4, 2 * i + j);
        for (Eigen::Index s = 0; s < count; ++s) {
          const Vec3<double>& n = elements.normals()[samples[s].element];
          into.row(s) += R(R(n[i]) * R(n[j])) * along.row(s);
        }
      }
    for (Eigen::Index s = 0; s < count; ++s)
      if (!into.row(s).allFinite())
        throw InputError(
            fmt::format("second derivatives are not finite at sample {} of {} on edge {}: it lies where two of the "
                        "edge's pieces meet, and other numbers of samples or pieces are wanted",
                        s % samples_an_edge + 1, samples_an_edge, samples[s].element));
  }
  return rows;
}

template <Scalar R>
BoundaryRows<R> position_rows(const CageCoordinates& coordinates, const std::vector<Constraints::Position>& positions) {
  std::vector<Vec3<double>> points;
  std::vector<Vec3<R>> at;
  points.reserve(positions.size());
  at.reserve(positions.size());
  for (const Constraints::Position& position : positions) {
    points.emplace_back(position.at[0], position.at[1], 0);
    at.push_back(convert<R>(points.back()));
  }
  const auto tables = coordinates.at<R>(at, 0);
  check_inside<R>("positions", points, tables[0], 2);
  return {component(tables[0], at.size(), 0, 1, 0), component(tables[1], at.size(), 0, 1, 0)};
}

template <Scalar R>
NormalsAt<R> normals_at(const CageElements& rest, const Matrix<R>& from, const Matrix<R>& moved) {
  using std::hypot;
  const auto edges = static_cast<Eigen::Index>(rest.count());
  NormalsAt<R> found{Matrix<R>(edges, 2), Matrix<R>::Zero(2 * edges, 2 * from.rows())};
  for (Eigen::Index e = 0; e < edges; ++e) {
    const auto ends = rest.vertices_of(static_cast<std::size_t>(e));
    const auto step = [&](int c) {
      return R((from(ends[1], c) - from(ends[0], c)) + (moved(ends[1], c) - moved(ends[0], c)));
    };
    const R x = step(0), y = step(1);
    const R length = hypot(x, y);
    if (!(length > 0))
      throw InputError(
          fmt::format("the posed segment {} (vertices {}, {}) has no length, and so no normal", e, ends[0], ends[1]));
    const std::array<R, 2> along{R(x / length), R(y / length)}, normal{along[1], R(-along[0])};
    for (int a = 0; a < 2; ++a) {
      found.normals(e, a) = normal[a];
      // d n' = -t' (n' . d(edge)) / length
      for (int b = 0; b < 2; ++b) {
        const R slope = -along[a] * normal[b] / length;
        found.derivative(2 * e + a, 2 * ends[1] + b) += slope;
        found.derivative(2 * e + a, 2 * ends[0] + b) -= slope;
      }
    }
  }
  return found;
}

template <Scalar R>
Matrix<R> jacobian(const BoundaryRows<R>& rows, const NormalsAt<R>& normals) {
  const Eigen::Index count = rows.of_vertices.rows(), vertices = rows.of_vertices.cols(),
                     edges = rows.of_normals.cols();
  Matrix<R> found(2 * count, 2 * vertices);
  for (int a = 0; a < 2; ++a) {
    const auto every_other = [&](Eigen::Index n) { return Eigen::seqN(a, n, Eigen::fix<2>); };
    const Matrix<R> slopes = normals.derivative(every_other(edges), Eigen::all);
    Matrix<R> of_component = rows.of_normals * slopes;
    of_component(Eigen::all, every_other(vertices)) += rows.of_vertices;
    found(every_other(count), Eigen::all) = of_component;
  }
  return found;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                                \
  template BoundaryRows<R> thickness_rows<R>(const CageCoordinates&, int);                                      \
  template BoundaryRows<R> position_rows<R>(const CageCoordinates&, const std::vector<Constraints::Position>&); \
  template NormalsAt<R> normals_at<R>(const CageElements&, const Matrix<R>&, const Matrix<R>&);                 \
  template Matrix<R> jacobian<R>(const BoundaryRows<R>&, const NormalsAt<R>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
