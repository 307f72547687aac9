// SPDX-License-Identifier: MIT
// Nodes and weights of the Gauss-Legendre rule on [0, 1], at any precision.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <memory>
#include <vector>

namespace cageproof {

template <Scalar R>
struct GaussLegendre {
  std::vector<R> nodes;    ///< rising, in (0, 1)
  std::vector<R> weights;  ///< sum 1
};

/// The n-point rule, exact for polynomials of degree 2n - 1; computed once a (scalar, n), safe from any thread.
/// \pre 1 <= n <= 4096
template <Scalar R>
const GaussLegendre<R>& gauss_legendre(int n);

}  // namespace cageproof
