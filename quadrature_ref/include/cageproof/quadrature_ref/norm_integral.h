// SPDX-License-Identifier: MIT
// How large a value is before its parts cancel: the integral of the kernel's norm.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::quadrature_ref {

/// The integral over the element of the norm of a formula's kernel (of all its tensors, basis functions included), in
/// the value's unit, to some per cent: by graded points in double, on quads by those of `adaptive`. On the element the
/// value's, just inside. The query's order is not looked at. NaN where the formula has no kernel, and for an element
/// without size.
double norm_integral(const Formula& formula, const Query<double>& query);

}  // namespace cageproof::quadrature_ref
