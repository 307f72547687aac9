// SPDX-License-Identifier: MIT
// Rotations, stretches and tractions of a pose ([C23] Section 4).
#pragma once

#include "../in_space.h"
#include "../turns.h"

#include "cageproof/deformation/deformer.h"

namespace cageproof::deformation {

/// The data that the corotational deformer takes from a pose: one rotation per vertex, and one rotation and traction
/// per normal (Owner::Normal). A flat element has one normal, a quad one per corner.
template <Scalar R>
struct Corotation {
  std::vector<SpaceMatrix<R>> of_vertices, of_normals;
  std::vector<Vec3<R>> tractions;  ///< s'_j of Eq 11, already turned: s_j m_j, balanced where asked
  std::vector<std::string> warnings;
};

struct CorotationOptions {
  double blend = 0;     ///< from one rotation and stretch for all (0) to those of each vertex and normal (1)
  double nu = 0.3;      ///< infinite: incompressible beyond, Green's
  double gamma = 0;     ///< of bulging, Eq 14
  bool balance = true;  ///< Eq 15
};

/// For a pose of the elements' vertices. mu is one. \throws InputError where an element has no normal that is needed
template <Scalar R>
Corotation<R> corotation_of(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                            const CorotationOptions& options);

/// The unit normal at rest that a coordinate multiplies. \param from the rest vertices in that unit
template <Scalar R>
Vec3<R> rest_normal(const CageElements& rest, const std::vector<Vec3<R>>& from, const R& unit, const NormalPlace& at,
                    std::size_t coordinate);

/// nu/(1 - 2 nu), -1/2 in the limit.
template <Scalar R>
R volume_factor(double nu);

}  // namespace cageproof::deformation
