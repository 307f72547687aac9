// SPDX-License-Identifier: MIT
// How many Gauss-Legendre points an interval needs, and how to cut a long one: from where the integrand is singular.
#pragma once

#include <boost/container/static_vector.hpp>

#include <complex>
#include <span>
#include <vector>

namespace cageproof::quadrature_ref {

/// Points of the complex plane where the integrand is singular; their conjugates are implied. Five are the most that a
/// frame has.
using Singularities = boost::container::static_vector<std::complex<double>, 5>;

/// The number of Gauss-Legendre points for `digits` decimal digits (relative to the integrand's maximum) on [lo, hi]:
/// the least of max|f| rho^(-2n) over the Bernstein ellipses that keep off the singularities, for integrands that grow
/// like exp(4 |Re z|).
int nodes_for(double lo, double hi, const Singularities& singular, double digits);

/// The design of a composite rule: panels as long as `nodes` points can carry to `digits` digits.
struct PanelDesign {
  int nodes;
  double digits;
};

/// Sets `ends` to the panels' boundaries from lo to hi, both included. \pre lo <= hi, finite
void set_panel_ends(double lo, double hi, const Singularities& singular, const PanelDesign& design,
                    std::vector<double>& ends);

}  // namespace cageproof::quadrature_ref
