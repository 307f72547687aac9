// SPDX-License-Identifier: MIT
#include "line_functions.h"

#include <cmath>

namespace cageproof::quadrature_ref::certified {
namespace {

constexpr double kSmallRatio = -6;  // log2 of c/S^2 below which series are summed

// sum over k of (k+j)!/k! z^k/(2k+2j+2m+1). From the k-th on, terms fall by (k+1+j)/(k+1) z at least, at most 1/2 where
// k + 1 >= j and |z| <= 1/4: the rest is at most twice the first term left out.
Real function_series(const Real& z, int m, int j) {
  Real sum, power(1), term;
  double size = 0;
  for (int k = 0;; ++k) {
    // power: (k+j)!/k! z^k.
    if (k == 0)
      for (int i = 2; i <= j; ++i) power = power * i;
    term = power / (2 * (k + j + m) + 1);
    size = term.log2_size();
    if (k + 1 >= j && (size < -static_cast<double>(working_bits) - 8 || !term.is_finite())) break;
    sum += term;
    power = power * z * (k + 1 + j) / (k + 1);
  }
  return sum.widened(term * 2);
}

}  // namespace

std::vector<std::vector<Real>> line_functions(const SeenLine& line, int functions, int derivatives) {
  std::vector<std::vector<Real>> G(functions, std::vector<Real>(derivatives));
  if (functions == 0) return G;
  const Real inverse = Real(1) / line.S, square = inverse * inverse, z = line.c * square;
  if (z.log2_size() < kSmallRatio) {
    Real lead = inverse;  // S^(-2m-1)
    for (int m = 0; m < functions; ++m, lead = lead * square) {
      Real scale = lead;
      for (int j = 0; j < derivatives; ++j, scale = scale * square) G[m][j] = scale * function_series(z, m, j);
    }
    return G;
  }
  // atanh(y/S)/y for y^2 = c, where S^2 - y^2 = 2w.
  const Real length = sqrt(line.c), sum = line.S + length, twice = line.w * 2;
  G[0][0] = log(sum * sum / twice) / (length * 2);
  Real power = inverse;
  for (int m = 1; m < functions; ++m, power = power * square) G[m][0] = (G[m - 1][0] - power / (2 * m - 1)) / line.c;
  // S d/dS G + 2c d/dc G = -(2m + 1) G, and d/dS G = -S^(-2m)/(2w).
  Real lead = line.S;  // S^(1-2m)
  for (int m = 0; m < functions; ++m, lead = lead * square) {
    Real boundary = lead / twice;  // S^(1-2m) j!/(2w)^(j+1)
    for (int j = 0; j + 1 < derivatives; ++j) {
      G[m][j + 1] = (boundary - G[m][j] * (2 * m + 1 + 2 * j)) / (line.c * 2);
      boundary = boundary * (j + 1) / twice;
    }
  }
  return G;
}

std::vector<Real> line_angles(const SeenLine& line, int derivatives) {
  std::vector<Real> angles(derivatives);
  if (arb_is_positive(line.g.raw()) != 0) {
    const Real inverse = Real(1) / line.g, square = inverse * inverse, z = line.D * square;
    if (z.log2_size() < kSmallRatio) {
      // (1/g) sum of (-D/g^2)^k/(2k+1).
      Real scale = inverse;
      for (int j = 0; j < derivatives; ++j, scale = -(scale * square)) angles[j] = scale * function_series(-z, 0, j);
      return angles;
    }
  }
  const Real root = sqrt(line.D), ab = line.a * line.b, over = Real(1) / (ab * ab);
  Real angle;
  arb_atan2(angle.raw(), root.raw(), line.g.raw(), working_bits);
  angles[0] = angle / root;
  // g d/dg + 2D d/dD = -1, and d/dg = -1/(D + g^2).
  Real boundary = line.g * over;  // g (-1)^j j! (ab)^(-2(j+1))
  for (int j = 0; j + 1 < derivatives; ++j) {
    angles[j + 1] = (boundary - angles[j] * (1 + 2 * j)) / (line.D * 2);
    boundary = boundary * over * -(j + 1);
  }
  return angles;
}

}  // namespace cageproof::quadrature_ref::certified
