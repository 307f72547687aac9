// SPDX-License-Identifier: MIT
// Somigliana coordinates for every Poisson's ratio at once ([C23] Section 5).
#pragma once

#include "cageproof/core/coordinates.h"

namespace cageproof::deformation {

/// Kelvin's kernels are linear in 1/(1 - nu): T = T1 + T2/(1 - nu) and K = K1 + K2/(1 - nu) with parts that do not
/// depend on nu. Blocks: T1, K1, which are the coordinates of an infinite nu, then T2, K2.
/// \param options of kind `somigliana`; its parameters are ignored, mu is one
CageCoordinates somigliana_parts(const Cage& cage, const CoordinateOptions& options);

/// T and K of one nu, from tables of the parts. \param nu infinite, or any number but 1
template <Scalar R>
std::vector<CoordinateTable<R>> assembled(std::span<const CoordinateTable<R>> parts, double nu);

}  // namespace cageproof::deformation
