// SPDX-License-Identifier: MIT
// Somigliana coordinates for every Poisson's ratio at once ([C23] Section 5).
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof::deformation {

/// Kelvin's kernels are linear in 1/(1 - nu), so that T and K of two values of nu give those of any. Blocks: T1, K1 of
/// one, T2, K2 of the other. Not for printed forms, whose misprints are not linear.
/// \param keeps_quads whether they are those of kind `quad_somigliana`, or of `somigliana` \param options of the kind;
/// its parameters are ignored, mu is one
CageCoordinates somigliana_parts(const Cage& cage, bool keeps_quads, const CoordinateOptions& options);

/// T and K of a nu, from tables of the parts. \param nu infinite, or any number but 1
template <Scalar R>
std::vector<CoordinateTable<R>> assembled(std::span<const CoordinateTable<R>> parts, double nu);

}  // namespace cageproof::deformation
