// SPDX-License-Identifier: MIT
// What [T24] makes of the layers' free densities L' and D' (Section 4.1, Appendix D): linear in V' and N'.
#pragma once

#include "samples.h"

namespace cageproof::deformation {

/// The account of the systems that were solved, which takes as long as solving: none, their descriptions, or the sizes
/// that solutions are rounded by.
enum class Account { None, Systems, Terms };

/// (L'; D') = to_vertices V' + to_normals N', in the user's unit of length. Rows: a vertex each, then an element each,
/// or a normal each where quads are kept. Columns of to_normals: an element each, a corner each where normal
/// derivatives are affine, or a normal each.
template <Scalar R>
struct Regularisation {
  Matrix<R> to_vertices, to_normals;
  std::vector<SolvedSystem> solved;  ///< with Account::Systems
  std::vector<std::string> warnings;
  Matrix<double> terms;  ///< with Account::Terms: of to_vertices beside to_normals (rounding_terms)
};

/// (1,3), Eq 21-30: least |A X - b|^2 gamma_D + |B X|^2 with the Dirichlet and Laplacian misfits at the samples.
/// \param weight gamma_D times the fourth power of the layers' unit, at least 0; 0 is Green, by definition: no layers
template <Scalar R>
Regularisation<R> one_three(const SampledLayers<R>& layers, const R& weight, Account account = Account::Systems);

/// The matrix that takes misfits b of (1,3) at the samples to densities, in the layers' unit: C_L above C_D, Eq 29.
/// \param weight as of one_three; zeros for 0
template <Scalar R>
Matrix<R> one_three_inverse(const SampledLayers<R>& layers, const R& weight);

/// (1,2), D.1: values and normal derivatives at the samples.
/// \param normal_slopes of phi, what multiplies normal derivatives, phibar and psibar at the samples along the rest
/// normals of their elements, in the user's unit \param normals what normal derivatives are at the samples, a row each
template <Scalar R>
Regularisation<R> one_two(const SampledLayers<R>& layers, const std::array<Matrix<R>, 4>& normal_slopes,
                          const Matrix<R>& normals, Account account = Account::Systems);

/// Weber's construction in space, D.2: D' of the Laplacian's own Green identity, then values.
template <Scalar R>
Regularisation<R> weber(const SampledLayers<R>& layers, Account account = Account::Systems);

}  // namespace cageproof::deformation
