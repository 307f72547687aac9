// SPDX-License-Identifier: MIT
// Least squares by a rank-revealing orthogonal factorisation.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <string>

namespace cageproof::deformation {

/// The solution of least residual and least norm of matrix x solution = right, and what there is to say of it. Columns
/// that others give to 1e-13 count as dependent, in every scalar alike. The condition is that of the factorisation's
/// triangle, from its singular values.
/// \param solved where what was solved is described; null where nobody asks
template <Scalar R>
Matrix<R> least_squares(const Matrix<R>& matrix, const Matrix<R>& right, std::string name,
                        std::vector<SolvedSystem>* solved);

}  // namespace cageproof::deformation
