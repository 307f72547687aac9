// SPDX-License-Identifier: MIT
// All complex zeros of a small polynomial in double.
#pragma once

#include <array>
#include <complex>
#include <vector>

namespace cageproof::quadrature_ref {

/// Zeros of c0 + c1 z + ... + c4 z^4 by Aberth's iteration, started on the radii of the Newton polygon, so that zeros
/// of very different size are found. Each to a few units of its own conditioning; zeros beyond 1e60 may be left out.
std::vector<std::complex<double>> polynomial_zeros(const std::array<double, 5>& coefficients);

}  // namespace cageproof::quadrature_ref
