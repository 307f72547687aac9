// SPDX-License-Identifier: MIT
// Stretches of posed normals that make an energy least: [T24] Eq 32 and 33, [W12] Eq 20.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// The normal derivatives sigma_t n'_t, one row per element, that make |fixed + of_normals N'| least.
/// \param of_normals rows x elements \param fixed rows x dimension, with what of_normals makes of `start` times units
/// in it \param units the posed unit normals, one row per element \param start stretches next to the least, one row per
/// element: roundings are relative to the difference from them \param nonnegative whether sigma >= 0 is asked for
/// \param report takes the system, figures "least sigma", "largest sigma" and the number of negative or zero sigma, and
/// warnings
template <Scalar R>
Matrix<R> least_stretched(const Matrix<R>& of_normals, const Matrix<R>& fixed, const Matrix<R>& units,
                          const Matrix<R>& start, bool nonnegative, DeformationReport& report);

}  // namespace cageproof::deformation
