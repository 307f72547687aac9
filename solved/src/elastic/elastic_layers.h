// SPDX-License-Identifier: MIT
// Kelvin's layers ([C23] Eq 3, 4 and 8 in the plane) on a refined polygon, off the polygon and on it.
#pragma once

#include "../boundary/boundary_layers.h"

#include <array>
#include <span>
#include <string>

namespace cageproof::solved {

/// Evaluations of `kelvin_displacement` and `kelvin_traction` of segments or triangles.
struct ElasticEvaluations {
  Evaluation displacement, traction;

  /// \param dimension of the space, 2 or 3 \param name of both; empty for the recommended ones
  /// \throws InputError where one has none of that name
  ElasticEvaluations(int dimension, const std::string& name);
};

/// Tables and matrices have two rows per displacement and two columns per cause of it.
template <Scalar R>
class ElasticLayers {
 public:
  using At = RefinedPolygon::At<R>;

  /// Keeps references. \param nu Poisson's ratio; the shear modulus is one
  ElasticLayers(const RefinedPolygon& polygon, const ElasticEvaluations& evaluations, double nu);

  /// Zeros for the displacements of all pieces: [point][piece][row][column][derivatives].
  CoordinateTable<R> table(std::size_t points, int order) const;

  /// The displacements of all pieces at points off the polygon: adds to a table.
  void add(std::span<const At> points, int order, CoordinateTable<R>& table) const;

  /// The same at one point on the polygon, limits from inside; pieces of the edges that it is on are seen in their
  /// edge's own direction, in which it is exactly on their line.
  /// \param on an edge that the point is on; both that meet where it is a vertex
  void add_on(const At& point, std::span<const OnEdge<R>> on, int order, CoordinateTable<R>& table) const;

  /// The boundary's equation K t = (H - T) u, with two rows per collocation point.
  struct Equations {
    Matrix<R> displacement;  ///< K: two columns per piece, of tractions that are constant on it
    Matrix<R> data;          ///< H - T: two columns per vertex, of displacements that are affine on edges
  };
  Equations equations(std::span<const CollocationPoint> points) const;

 private:
  using Matrix2 = Eigen::Matrix<R, 2, 2>;
  void add_pieces(int edge, std::span<const At> points, int order, CoordinateTable<R>& table) const;
  void add_pieces_in_line(const OnEdge<R>& on, int order, CoordinateTable<R>& table) const;
  std::array<Matrix2, 2> tractions(std::span<const Vec3<R>> ends, const Vec3<R>& point) const;
  Matrix2 pull_to_end(const OnEdge<R>& on) const;
  int seer_of(int edge, const At& point) const;
  void put_data(const std::vector<OnEdge<R>>& on, const At& point, Eigen::Index row, Matrix<R>& data) const;

  const RefinedPolygon& polygon_;
  const ElasticEvaluations& evaluations_;
  std::array<R, 2> parameters_;
};

}  // namespace cageproof::solved
