// SPDX-License-Identifier: MIT
// [T24]'s constructions of the layers' densities with their parameters: of deformers and of kinds of coordinates.
#pragma once

#include "regularisation.h"

#include <functional>

namespace cageproof::deformation {

/// (1,3): Section 4.1; (1,2): Appendix D.1; Weber's: D.2.
enum class Construction { OneThree, OneTwo, Weber };

/// How often elements are split for samples.
KindParameter level_parameter();

/// Whether normal derivatives are constant on elements (0), or affine (1).
KindParameter neumann_parameter();

/// gamma_d and gamma_rel of (1,3); none of the others.
std::vector<KindParameter> weight_parameters(Construction construction);

/// gamma_D over the fourth power of a length: where it is not zero, neither is what it is in another unit.
template <Scalar R>
R weight_in(double gamma_d, double unit);

/// gamma_D of (1,3) times the fourth power of the layers' unit.
/// \param weights gamma_d and gamma_rel, the second in place of the first where it is not zero
template <Scalar R>
R one_three_weight(std::span<const double> weights, const SampledLayers<R>& layers) {
  return weights[1] != 0 ? weight_in<R>(weights[1], 1 / layers.size) : weight_in<R>(weights[0], layers.unit);
}

/// Whether coordinates by a construction are solved in 50 digits: where deformers by it are, because double has too few
/// for thin cages, and where the systems' condition takes more digits than are promised.
/// \param solved_in_double solves the systems in double, and describes them; asked only where it decides
bool takes_50_digits(Construction construction, const CageCoordinates& layers, int level,
                     const std::function<std::vector<SolvedSystem>()>& solved_in_double);

/// \param coordinates of kind `biharmonic` or `biharmonic_affine`; (1,3) takes `quad_biharmonic`, too
/// \param weights gamma_d and gamma_rel of (1,3), the second in place of the first where it is not zero
/// \throws InputError as checked_limits
template <Scalar R>
Regularisation<R> regularisation_by(Construction construction, const CageCoordinates& coordinates, int level,
                                    std::span<const double> weights, Account account);

}  // namespace cageproof::deformation
