// SPDX-License-Identifier: MIT
// Cage coordinates: sums of a formula over a cage's triangles, one block of coordinates a formula.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/evaluation.h"

namespace cageproof {

/// One block of a kind of coordinates: a coordinate (a number, or a 3 x 3 matrix) a vertex where its formula has one tensor a corner, else
/// one a triangle.
struct CoordinateBlock {
  std::string_view label;    ///< "phi", "psi" ...
  std::string_view formula;  ///< of the catalogue
  /// What the block multiplies when a linear map is reproduced: the vertices, the triangles' outward unit normals, or nothing.
  enum class Reproduces { Vertices, Normals, Nothing } reproduces;
  /// What the normals are multiplied with, from the formula's parameters; null for one.
  double (*normal_factor)(std::span<const double> parameters) = nullptr;
};

/// A kind of cage coordinates.
struct CoordinateKind {
  std::string_view name;
  std::string_view source;
  std::vector<CoordinateBlock> blocks;
  bool normalised;  ///< divided by their sum (mean value coordinates), and interpolating on the cage
};

/// mean_value, green, biharmonic, somigliana.
std::span<const CoordinateKind> coordinate_kinds();

/// The parameters of a kind's formulas, which they share; none for most kinds.
const std::vector<Parameter>& parameters_of(const CoordinateKind& kind);

/// The kind of that name, or null.
const CoordinateKind* find_coordinate_kind(std::string_view name);

/// A cage triangle that a point lies on, exactly, and its hat functions there.
struct Touching {
  int triangle;
  std::array<double, 3> hats;
};

/// Coordinates of points in one cage. Keeps a reference to the kind, copies of the rest; safe from any thread.
class CageCoordinates {
 public:
  /// \param parameters in the order of parameters_of(kind); empty for their defaults
  /// \throws InputError when a block's formula has no evaluation of that name, or a parameter is out of range
  CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation, Triangulation rule,
                  std::vector<double> parameters = {});

  const CoordinateKind& kind() const { return *kind_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  /// Outward unit normals of the triangles.
  const std::vector<Vec3<double>>& normals() const { return normals_; }
  /// Coordinates of block b: the number of vertices or of triangles.
  int size(int b) const;
  /// Numbers a coordinate of block b: 1, or 9 for a 3 x 3 matrix, row by row.
  int entries(int b) const;
  /// What block b multiplies the normals with when a linear map is reproduced.
  double normal_factor(int b) const;
  int max_order() const { return max_order_; }

  /// One result a block: value [coordinate][entry], gradient [coordinate][entry][i], Hessian [coordinate][entry][i][j].
  /// On the cage the values are the limits from inside: interpolating kinds give the hat functions; derivatives that do not
  /// exist are NaN.
  template <Scalar R>
  std::vector<Result<R>> at(const Vec3<double>& point, int order) const;

  /// As `at`, for a point known to lie off the cage, in the scalar's own precision.
  template <Scalar R>
  std::vector<Result<R>> at_off_cage(const Vec3<R>& point, int order) const;

  /// The triangles that the point lies on, border included, decided exactly; the hat functions are rounded.
  std::vector<Touching> touching(const Vec3<double>& point) const;

 private:
  template <Scalar R>
  Result<R> block_at(int b, const Vec3<R>& eta, int order, const std::vector<Touching>& on) const;

  const CoordinateKind* kind_;
  std::vector<Vec3<double>> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Vec3<double>> normals_;
  std::vector<Evaluation> evaluations_;
  std::vector<double> parameters_;
  int max_order_ = 2;
};

}  // namespace cageproof
