// SPDX-License-Identifier: MIT
// Cage coordinates: sums of a formula over a cage's faces, one block of coordinates a formula.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/evaluation.h"

#include <functional>

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
  /// What quads are summed with, of the same shape; empty where quads become triangles.
  std::string_view quad_formula = {};
};

/// Coordinates of one point, one a vertex, summing to one; NaN where there are none. Safe from any thread.
using DirectCoordinates = std::function<std::vector<double>(const Vec3<double>& point)>;

/// A kind of cage coordinates.
struct CoordinateKind {
  std::string_view name;
  std::string_view source;
  std::vector<CoordinateBlock> blocks;
  bool normalised;  ///< divided by their sum (mean value coordinates), and interpolating on the cage
  /// For kinds that are no sum over faces: makes what computes all coordinates of a point, in double and without derivatives. Their one block
  /// states the shape.
  DirectCoordinates (*direct)(const Cage& cage, std::string_view evaluation) = nullptr;
  /// Why there may be points without coordinates; empty for kinds that have them everywhere.
  std::string_view missing_because = {};

  /// Whether the cage's quads stay whole.
  bool keeps_quads() const { return !blocks.front().quad_formula.empty(); }
};

/// mean_value, quad_mean_value, green, biharmonic, somigliana, and those that rooms linked into the program add, by name.
std::span<const CoordinateKind> coordinate_kinds();

/// Adds a kind at program start: `const RegisterCoordinateKind r{...};` at namespace scope of a .cpp.
struct RegisterCoordinateKind {
  explicit RegisterCoordinateKind(CoordinateKind kind);
};

/// The parameters of a kind's formulas, which they share; none for most kinds.
const std::vector<Parameter>& parameters_of(const CoordinateKind& kind);

/// The kind of that name, or null.
const CoordinateKind* find_coordinate_kind(std::string_view name);

/// Whether the kind has coordinates in the cage: it triangulates quads, or all are valid, or the cage allows others.
bool accepts(const CoordinateKind& kind, const Cage& cage);

/// A triangle or quad that a point lies on, exactly, and its basis functions there: hat functions, or bilinear ones.
struct Touching {
  int element;
  std::array<double, 4> basis;
};

/// Coordinates of points in one cage. Keeps a reference to the kind, copies of the rest; safe from any thread.
class CageCoordinates {
 public:
  /// \param parameters in the order of parameters_of(kind); empty for their defaults
  /// \param evaluation of the quads' formula for kinds that keep quads; triangles then take it where they have it, else closed_form
  /// \throws InputError when a block's formula has no evaluation of that name, a parameter is out of range, or a kind that keeps quads
  ///   meets an invalid one that the cage does not allow
  CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation, Triangulation rule,
                  std::vector<double> parameters = {});

  const CoordinateKind& kind() const { return *kind_; }
  /// What is summed over: the cage's faces, quads as triangles unless the kind keeps them.
  const std::vector<Face>& elements() const { return elements_; }
  std::vector<Vec3<double>> corners(int element) const;
  /// Outward unit normals of triangles, and of quads' area vectors.
  const std::vector<Vec3<double>>& normals() const { return normals_; }
  /// The outward unit normal where a point touches; of a bilinear quad, there.
  Vec3<double> normal_at(const Touching& touch) const;
  /// How block b is evaluated on an element. \pre the kind is a sum over elements
  const Evaluation& evaluation_on(int b, int element) const {
    return elements_[element].size() == 3 ? evaluations_[b] : quad_evaluations_[b];
  }
  /// Coordinates of block b: the number of vertices or of elements.
  int size(int b) const;
  /// Numbers a coordinate of block b: 1, or 9 for a 3 x 3 matrix, row by row.
  int entries(int b) const;
  /// What block b multiplies the normals with when a linear map is reproduced.
  double normal_factor(int b) const;
  int max_order() const { return max_order_; }

  /// One result a block: value [coordinate][entry], gradient [coordinate][entry][i], Hessian [coordinate][entry][i][j].
  /// On the cage the values are the limits from inside: interpolating kinds give the basis functions; derivatives that do not
  /// exist are NaN. \pre order <= max_order()
  template <Scalar R>
  std::vector<Result<R>> at(const Vec3<double>& point, int order) const;

  /// As `at`, for a point known to lie off the cage, in the scalar's own precision.
  template <Scalar R>
  std::vector<Result<R>> at_off_cage(const Vec3<R>& point, int order) const;

  /// The elements that the point lies on, border included, decided exactly; the basis functions are rounded.
  std::vector<Touching> touching(const Vec3<double>& point) const;

 private:
  template <Scalar R>
  Result<R> block_at(int b, const Vec3<R>& eta, int order, const std::vector<Touching>& on) const;

  const CoordinateKind* kind_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> elements_;
  std::vector<Vec3<double>> normals_;
  std::vector<Evaluation> evaluations_;       // of blocks, on triangles
  std::vector<Evaluation> quad_evaluations_;  // of blocks, on quads; empty for kinds that keep none
  DirectCoordinates direct_;
  std::vector<double> parameters_;
  int max_order_ = 2;
};

}  // namespace cageproof
