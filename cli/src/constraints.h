// SPDX-License-Identifier: MIT
// Constraints of deformers, as users write them.
#pragma once

#include "cageproof/deformation/constrained.h"

#include <filesystem>

namespace cageproof::cli {

/// Reads an object {"schema":"cageproof-constraints","schema_version":1,"positions":[{"at":[x,y,z],"to":[x,y,z]},...],
/// "orientations":[{"at":[x,y,z],"jacobian":[[...],[...],[...]]},...],"rotations":[[x,y,z],...],"hessians":[[x,y,z],...]}:
/// the constraints' lists may be missing; row c of a Jacobian holds the derivatives of component c. In the plane points
/// have two numbers and Jacobians two rows of two.
/// \throws InputError naming the file and, where there is one, the key and the index, for anything else: malformed
/// JSON, a key that is unknown or occurs twice, another schema or version, numbers that are none or not finite
deformation::Constraints read_constraints(const std::filesystem::path& file, int dimension);

}  // namespace cageproof::cli
