// SPDX-License-Identifier: MIT
// A formula: a kernel on an element, a row of the catalogue, and everything that checks, benchmarks and reports may
// know of it.
#pragma once

#include "cageproof/core/geometry/element.h"

#include <cmath>
#include <cstddef>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// A formula's parameter (Poisson ratio, shear modulus): name, default `preset`, open range, and limits outside it.
struct Parameter {
  std::string_view name;
  double preset;
  double lowest;
  double highest;
  bool includes_highest = false;   ///< the limit `highest` itself is allowed
  bool includes_infinity = false;  ///< the limits +-infinity are allowed
  bool whole = false;              ///< only whole numbers are allowed

  /// Whether the formula is defined for this value.
  bool allows(double value) const {
    if (whole && value != std::floor(value)) return false;
    if (std::isinf(value)) return includes_infinity;
    return lowest < value && (value < highest || (includes_highest && value == highest));
  }
};

/// The shape of a formula's results: one tensor per element, or one per corner, of rows x columns entries. Rows and
/// columns are 1 (a number) or the dimension of the space.
struct Shape {
  bool per_corner = false;
  int rows = 1;
  int columns = 1;

  int entries() const { return rows * columns; }
  /// How many of rows and columns run over space, and turn with it: 0 for numbers, 2 for matrices.
  int space_indices() const { return (rows > 1) + (columns > 1); }
};

/// The trace of the Hessian: nothing known, zero (harmonic), another formula (biharmonic), or the formula itself with
/// its last parameter one less (polyharmonic); where that parameter would be zero, the trace is zero.
struct Laplacian {
  enum class Kind { Unknown, Zero, Formula, LowerOrder } kind = Kind::Unknown;
  std::string_view formula = {};
};

/// Value just inside minus value just outside a face: number + pi_multiple pi, times the corner's basis function if per
/// corner, times the identity if the tensor is a matrix.
struct FaceJump {
  double number = 0;
  double pi_multiple = 0;
  bool diverges = false;
};

/// The term that multiplies ln r in a kernel of the plane: factor r^(2 squares), with or without x.n; in matrices it
/// multiplies the identity. The factor is zero for kernels without a logarithm.
struct Logarithm {
  double factor = 0;
  int squares = 0;
  bool height = false;  ///< with x.n
};

/// The identity of a double layer's moments f and a single layer g on an element in space whose corners, seen from the
/// point, are x_k: sum_k f_k x_k + factor sum_k g_k N_k = 1/(weight pi) sum over sides of (x_k cross side) times the
/// mean of r^power along the side. On flat elements, g N is one number times the unit normal.
struct SideRelation {
  std::string_view single_layer = {};  ///< g; none where empty
  double factor = 1;
  double weight = 4;  ///< a divisor
  int power = -1;     ///< -1 or 1
};

/// The behaviour of a formula for given parameters, in two respects. Under a change of unit, f(s element, s point) =
/// s^degree f(element, point), s > 0; kernels with a logarithm of the distance add s^degree log(s) times the integral
/// of the term that multiplies it; derivatives follow. Across the element, values jump as stated.
struct Behaviour {
  int degree;
  Logarithm logarithmic = {};
  FaceJump face_jump = {};
};

/// One row of the catalogue. Every relation a campaign checks is stated here as data, so that no check knows a formula.
struct Formula {
  std::string_view name;        ///< stable, `<element>.<kernel>`
  std::string_view symbol;      ///< the papers' symbol
  std::string_view source;      ///< paper keys and equations
  std::string_view definition;  ///< the defining integral, in one line
  ElementKind element;
  Shape shape;
  int degree;     ///< Behaviour::degree
  int flip_sign;  ///< +1 or -1: the factor when the element's orientation is reversed
  /// Whether the kernel has the factor x.n: it vanishes where the point is in a flat element's plane, or on a segment's
  /// line.
  bool vanishes_in_plane = false;
  /// Whether straight above a flat element terms of the gradient exceed their sum by the factor 1 + distance/size.
  bool gradient_cancels_above = false;
  Laplacian laplacian;
  FaceJump face_jump;
  std::vector<Parameter> parameters;
  Logarithm logarithmic = {};
  /// Whether the integral is over the element's own parameters, u and v in [0, 1], without the area element: each of
  /// four like parts then adds a quarter of its own value.
  bool by_parameters = false;
  SideRelation side_relation = {};
  /// The behaviour of a formula whose degree, logarithm or jump depends on its parameters; null for others.
  Behaviour (*behaviour_of)(std::span<const double> parameters) = nullptr;

  Behaviour behaviour(std::span<const double> given) const {
    return behaviour_of ? behaviour_of(given) : Behaviour{degree, logarithmic, face_jump};
  }
  int corners() const { return corner_count(element); }
  /// Number of scalars of the value: (corners or 1) x rows x columns.
  int components() const { return tensors() * shape.entries(); }
  int tensors() const { return shape.per_corner ? corners() : 1; }
  int dim() const { return dimension(element); }
  /// The second half of the name: what is integrated.
  std::string_view kernel() const { return name.substr(name.find('.') + 1); }
};

/// The number of derivatives of one number: dim^order.
constexpr std::size_t derivative_count(int dim, int order) {
  std::size_t count = 1;
  for (int o = 0; o < order; ++o) count *= static_cast<std::size_t>(dim);
  return count;
}

/// All formulas, in the order in which reports list them: the catalogue's own, then those that others have added, by
/// name. Rows stay where they are.
const std::list<Formula>& catalogue();

/// The formula of that name, or null.
const Formula* find_formula(std::string_view name);

/// The formula of a kernel on an element, or null where there is none.
const Formula* find_formula(ElementKind element, std::string_view kernel);

/// The place of a formula in the catalogue; the catalogue's length for an unknown name.
std::size_t rank_of(std::string_view formula);

/// Adds a row at program start: `const RegisterFormula r{{.name = ...}};` at namespace scope of a .cpp.
struct RegisterFormula {
  /// \throws std::logic_error when there is a formula of that name, or the name does not begin with its element's
  explicit RegisterFormula(Formula formula);
};

}  // namespace cageproof
