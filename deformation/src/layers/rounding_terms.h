// SPDX-License-Identifier: MIT
// How large the roundings of a least squares solution are.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

namespace cageproof::deformation {

/// The sizes of what each entry of solution = pinv(matrix) right is rounded by, in units of the roundoff, beside what
/// is common to all columns: a factorisation's error is that of one matrix near by, and changes all columns alike, but
/// each column of the right side has its own roundings, r of its length, and its back substitution has those of the
/// matrix's columns, each times its entry. So row i is off by the length of row i of the pseudo-inverse times these.
Matrix<double> rounding_terms(const Matrix<double>& matrix, const Matrix<double>& right,
                              const Matrix<double>& solution);

}  // namespace cageproof::deformation
