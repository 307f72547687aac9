// SPDX-License-Identifier: MIT
// A formula: a row of the catalogue, and everything that checks, benchmarks and reports may know of it.
#pragma once

#include "cageproof/core/element.h"

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

namespace cageproof {

/// A formula's parameter (Poisson ratio, shear modulus): name, default and open range, with the limits that exist beside it.
struct Parameter {
  std::string_view name;
  double preset;
  double lowest;
  double highest;
  bool includes_highest = false;  ///< the limit `highest` itself is allowed
  bool includes_infinity = false; ///< the limits +-infinity are allowed

  /// Whether the formula is defined for this value.
  bool allows(double value) const {
    if (std::isinf(value)) return includes_infinity;
    return lowest < value && (value < highest || (includes_highest && value == highest));
  }
};

/// How a formula's tensor is made up: one tensor an element, or one a corner; the tensor has rows x columns entries.
struct Shape {
  bool per_corner = false;
  int rows = 1;
  int columns = 1;
};

/// What taking the trace of the Hessian must give: nothing known, zero (harmonic), or another formula (biharmonic).
struct Laplacian {
  enum class Kind { Unknown, Zero, Formula } kind = Kind::Unknown;
  std::string_view formula = {};
};

/// Value just inside minus value just outside a face: number + pi_multiple pi, times the corner's hat function if per corner, times the
/// identity if the tensor is a matrix.
struct FaceJump {
  double number = 0;
  double pi_multiple = 0;
  bool diverges = false;
};

/// One row of the catalogue. Every relation a campaign checks is stated here as data, so that no check knows a formula.
struct Formula {
  std::string_view name;        ///< stable, `element.what`
  std::string_view symbol;      ///< the papers' symbol
  std::string_view source;      ///< paper keys and equations
  std::string_view definition;  ///< the defining integral, in one line
  ElementKind element;
  Shape shape;
  int degree;       ///< f(s element, s point) = s^degree f(element, point), s > 0
  int flip_sign;    ///< +1 or -1: the factor when the element's orientation is reversed
  Laplacian laplacian;
  FaceJump face_jump;
  std::vector<Parameter> parameters;

  int corners() const { return corner_count(element); }
  /// Number of scalars of the value: (corners or 1) x rows x columns.
  int components() const { return (shape.per_corner ? corners() : 1) * shape.rows * shape.columns; }
  int dim() const { return dimension(element); }
};

/// All formulas, in the order in which reports list them.
std::span<const Formula> catalogue();

/// The formula of that name, or null.
const Formula* find_formula(std::string_view name);

}  // namespace cageproof
