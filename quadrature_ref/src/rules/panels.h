// SPDX-License-Identifier: MIT
// How many Gauss-Legendre points an interval needs, and how to cut a long one: from where the integrand is singular.
#pragma once

#include <complex>
#include <vector>

namespace cageproof::quadrature_ref {

/// Points of the complex plane where the integrand is singular; their conjugates are implied.
using Singularities = std::vector<std::complex<double>>;

/// The number of Gauss-Legendre points for `digits` decimal digits (relative to the integrand's maximum) on [lo, hi]:
/// the least of max|f| rho^(-2n) over the Bernstein ellipses that keep off the singularities, for integrands that grow
/// like exp(4 |Re z|).
int nodes_for(double lo, double hi, const Singularities& singular, double digits);

/// The design of a composite rule: panels as long as `nodes` points can carry to `digits` digits.
struct PanelDesign {
  int nodes;
  double digits;
};

/// Panel boundaries from lo to hi, both included. \pre lo <= hi
std::vector<double> panel_ends(double lo, double hi, const Singularities& singular, const PanelDesign& design);

}  // namespace cageproof::quadrature_ref
