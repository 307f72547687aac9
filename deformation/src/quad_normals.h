// SPDX-License-Identifier: MIT
// The normals of a posed bilinear quad, one per corner, stretched as the quad is.
#pragma once

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// Whether elements without area have normals of length zero; other stretches refuse them.
inline bool takes_no_area(Stretch stretch) { return stretch == Stretch::Area || stretch == Stretch::Product; }

/// sigma_k N'_k/|N_k| of each corner k of the quad, N = xi_u x xi_v at rest and N' posed:
///   sigma_k = int Phi_k s |N| du dv / int Phi_k |N'| du dv
/// with the stretch s of the map from the rest tangents to the posed ones at (u, v), whose rms is that of [Lipman et
/// al. 2008]; sigma_k = 1 for Stretch::Product. Where the quad is a parallelogram in both poses, these are the posed
/// unit normal times the stretch of its triangles. Integrals by Gauss-Legendre rules, whose points are doubled until
/// the error is below the roundings of R, or until 128 a direction where the posed quad folds over.
/// \param element a quad \throws InputError, naming it, for a posed quad that has no area anywhere, unless
/// takes_no_area(stretch)
template <Scalar R>
std::array<Vec3<R>, 4> quad_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                                    std::size_t element);

}  // namespace cageproof::deformation
