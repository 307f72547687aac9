// SPDX-License-Identifier: MIT
// Kernels as sums of constant * integer * x1^a x2^b x3^c r^(-q), or that times ln r, in the element's frame, x3 = x.n,
// and their derivatives. In the plane x1 is along the segment, and there is no x2.
#pragma once

#include "ball.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::quadrature_ref::certified {

/// A term without its integer factor.
struct Monomial {
  std::array<int, 3> powers{};  ///< of x1, x2, x3
  int q = 0;                    ///< r^(-q)
  int logarithms = 0;           ///< of r: none or one
  int constant = 0;             ///< 0: one; else number of one of the definition's constants, from 1
  friend auto operator<=>(const Monomial&, const Monomial&) = default;
  int in_plane() const { return powers[0] + powers[1]; }
  /// Whether its integral converges absolutely, uniformly in the point, with the point on the element, which has
  /// `extent` dimensions: two of a triangle, one of a segment.
  bool weakly_singular(int extent) const { return powers[0] + powers[1] + powers[2] + extent > q; }
};

/// A sum of terms.
class Polynomial {
 public:
  using Terms = std::map<Monomial, int>;
  Polynomial() = default;
  explicit Polynomial(const Monomial& monomial) { terms_[monomial] = 1; }
  const Terms& terms() const { return terms_; }
  /// The derivative with respect to coordinate i of the point: d x_j = -delta_ij, d r^(-q) = q x_i r^(-q-2), d ln r =
  /// -x_i r^(-2).
  Polynomial derivative(int i) const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);  ///< \pre at most one has constants
  friend Polynomial operator*(int factor, const Polynomial& a);

 private:
  void add(const Monomial& monomial, int factor);
  Terms terms_;
};

Polynomial coordinate(int i);        ///< x_i
Polynomial inverse_distance(int q);  ///< r^(-q)
Polynomial logarithm();              ///< ln r
Polynomial constant(int number);     ///< the definition's constant of that number, from 1

/// A formula's kernel, written once more from its definition: it uses no code of src/kernel.
struct Definition {
  std::string_view formula;
  bool per_corner;                     ///< weighted with the hat function of each corner
  std::vector<Polynomial> components;  ///< one, or a matrix row by row
  /// The constants' values, from the formula's parameters (infinite ones as infinite balls). One that is exactly zero
  /// takes its terms with it.
  std::function<std::vector<Real>(const std::vector<Real>& parameters)> constants;
};

/// All of them that have a row in the catalogue.
const std::vector<Definition>& definitions();

}  // namespace cageproof::quadrature_ref::certified
