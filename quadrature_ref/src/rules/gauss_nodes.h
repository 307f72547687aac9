// SPDX-License-Identifier: MIT
// Nodes and weights of the Gauss-Legendre rules for the integrals of this room. The evaluations that are checked
// against them take their nodes from core.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <vector>

namespace cageproof::quadrature_ref {

template <Scalar R>
struct GaussNodes {
  std::vector<R> nodes;    ///< rising, in (0, 1)
  std::vector<R> weights;  ///< sum 1
};

/// The n-point rule, exact for polynomials of degree 2n - 1, in R's digits; made once for each scalar and n, safe from
/// any thread. \pre 1 <= n <= 4096
template <Scalar R>
const GaussNodes<R>& gauss_nodes(int n);

}  // namespace cageproof::quadrature_ref
