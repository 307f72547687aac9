// SPDX-License-Identifier: MIT
// What [T24] Section 4.1 and Appendix D solve, as matrices that users may read, and what comes out of it for a pose.
#pragma once

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// A matrix with the name that [T24] gives it, in the user's unit of length.
struct NamedMatrix {
  std::string name;
  Matrix<double> values;
};

/// The matrices of a kind of regularised coordinates, computed anew: samples on the cage (S x dimension), their
/// elements (S x 1) and normals; M_V, Phi_V, Psi_V, Phibar_V, Psibar_V (one row per sample, Eq 22-23); C_11 (vertices x
/// vertices), C_12 (elements x vertices), C_21 and C_22 (Eq 27, for all constructions); of (1,3) C_L, C_D (Eq 29) and
/// gamma_D (1 x 1), too. None of other kinds.
/// \throws InputError as CageCoordinates, and for an evaluation without limits on the cage
std::vector<NamedMatrix> solved_matrices(std::string_view kind, const Cage& cage, const CoordinateOptions& options);

/// The data that a pose multiplies layers with, one row per coordinate: V (phi), N (psi), L (phibar) and D (psibar) of
/// Eq 19, whose sum its images are; fewer if the rest is zero. Empty for poses whose images are no such sum.
std::vector<NamedMatrix> layer_data(const CageCoordinates& coordinates, const Posed<double>& posed);

}  // namespace cageproof::deformation
