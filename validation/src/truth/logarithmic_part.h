// SPDX-License-Identifier: MIT
// Terms that a change of the unit of length adds to kernels with the logarithm of the distance.
#pragma once

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/numbers/linear.h"

#include <span>
#include <vector>

namespace cageproof::validation {

/// The integral over a segment of what stands before ln r in a kernel, or of its derivatives of that order, in the
/// order of results: a polynomial, which a few Gauss-Legendre points integrate exactly. Of matrices the kernel's
/// logarithm is a multiple of the identity. \param shape of the tensor, one per corner or one
std::vector<double> logarithmic_part(const Logarithm& logarithm, const Shape& shape,
                                     std::span<const Vec3<double>> corners, const Vec3<double>& point, int order);

}  // namespace cageproof::validation
