// SPDX-License-Identifier: MIT
// Proven bounds of the terms that expansions of far layers leave out beyond a degree of solid harmonics.
//
// With rho = |y|/r for a source y, seen from r, terms of degree l of 1/|x - y| are at most rho^l/r, and those of its
// gradient by y at most l rho^(l - 1)/r^2, since (1 - t^2) P_l'(t)^2 + l^2 P_l(t)^2 <= l^2 on [-1, 1] (Bernstein's
// inequality in Szegő's form). Their sums beyond the degree are these.
#pragma once

#include <cmath>

namespace cageproof::closed_form::batch {

/// Bound for 1/|x - y|, times r. \pre 0 <= rho < 1
inline double cut_off_single(int degree, double rho) { return std::pow(rho, degree + 1) / (1 - rho); }

/// Bound for the gradient of 1/|x - y| by y, times r^2.
inline double cut_off_double(int degree, double rho) {
  return std::pow(rho, degree) * ((degree + 1) * (1 - rho) + rho) / ((1 - rho) * (1 - rho));
}

}  // namespace cageproof::closed_form::batch
