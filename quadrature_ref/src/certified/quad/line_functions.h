// SPDX-License-Identifier: MIT
// The functions that integrals along a line are made of: G_m(S, c) = sum over k >= 0 of c^k S^(-2k-2m-1)/(2k+2m+1), and
// the angle under which the line is seen, and their derivatives.
#pragma once

#include "../ball.h"

#include <vector>

namespace cageproof::quadrature_ref::certified {

/// A line as its point sees it: distances of its ends, and what follows.
struct SeenLine {
  Real a, b;  ///< distances of the ends
  Real w;     ///< ab + (scalar product of the ends): positive off the line
  Real S;     ///< a + b
  Real c;     ///< squared length: S^2 - 2w
  Real g;     ///< scalar product of the ends
  Real D;     ///< a^2 b^2 - g^2: square of their vector product
};

/// G[m][j] is the j-th derivative of G_m by c, at the working_bits, for m < functions, j < derivatives. Not finite
/// where w is not known to be positive.
std::vector<std::vector<Real>> line_functions(const SeenLine& line, int functions, int derivatives);

/// The derivatives by D, g fixed, of the angle between the ends over its sine and ab: of atan2(sqrt(D), g)/sqrt(D).
std::vector<Real> line_angles(const SeenLine& line, int derivatives);

}  // namespace cageproof::quadrature_ref::certified
