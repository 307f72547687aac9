// SPDX-License-Identifier: MIT
// Ways to integrate a kernel over a bilinear quad, in its two parameters.
//
// The quad is xi(u, v) = sum_k Phi_k q_k over [0, 1]^2, N = xi_u x xi_v, its kernels are integrated against N du dv
// ([T18] Eq 3-4, 11); basis functions are Phi_k. No variable is integrated in closed form. All rules: the geometry is
// scaled by a power of two before, and the tensors are scaled back by the formula's degree of homogeneity, so that no
// unit of length over- or underflows on the way. A quad on a line, or an input that is not finite, gives NaN.
// `nodes` of the statement counts the kernel evaluations.
#pragma once

#include "rules/adaptive_limits.h"
#include "cageproof/quadrature_ref/kernel.h"

namespace cageproof::quadrature_ref::quad {

/// N x N Gauss-Legendre points in (u, v), for a block of points. Converges geometrically with the ratio of the point's
/// distance to the quad's size; useless closer than the nodes' spacing.
///
/// \pre 1 <= n <= 256
template <Scalar R>
void integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// N x N cells in (u, v), the kernel at each one's middle, for a block of points: the Riemann sum that public code
/// takes for the layers of twisted quads. Its error falls with N^-2 where the cells are smaller than the point's
/// distance.
///
/// \pre 1 <= n <= 512
template <Scalar R>
void integrate_midpoint(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// The relative tolerance of integrate_adaptive, norm-wise for each derivative order: all is computed in double.
template <Scalar R>
double adaptive_tolerance() {
  return std::same_as<R, float> ? 1e-4 : 1e-10;
}

/// In double (float and multiprecision too: inputs are taken exactly, tensors have double's digits). Cells about the
/// nearest point as in integrate_multiprecision; on each two rules, of which the finer one counts and the
/// difference is the cell's error; cells are bisected until for every derivative order asked the bound (sum of the
/// differences, and of rounding) is below the tolerance. `converged` is false when kAdaptiveNodeLimit or rounding
/// prevents that, `stated_digits` comes from the bound in both cases. On the quad the point is moved inside, against
/// the normal, by 1e-16 and by 1e-14 of its distance to the nearest side that it is not on, and both must agree; NaN
/// for kernels that diverge there, and where the normal vanishes. Nearer than 1e-120 of its extent without being on it,
/// nothing is stated: NaN, `stated_digits` 0, `converged` false.
/// Where entries leave the range of R, digits are those of the entries within it, and the infinities have their sign;
/// where double does not tell them, integrate_multiprecision is asked, however many nodes that takes.
template <Scalar R>
void integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result);

/// The integral to at least `digits` digits (the reference: 30, 60 for Mp100 and Mp200), norm-wise for each derivative
/// order (over the entries within R's range, where others leave it), for points at any distance. The parameter square
/// is cut into triangles at the point nearest to eta; in each, sinh substitutions along rays and across them, and
/// rectangles cut and given as many points as the complex zeros of r^2, which are known, demand; precision (50, 100,
/// 200 digits) as the share of the result and the cancellation do. Two sums with different centres, cuts and rules are
/// compared; `stated_digits` is the number of digits on which they agree (the better one is returned), the least over
/// the orders asked; `converged` is stated_digits >= 30. Where that would take more than about a second (five times
/// that for more than 30 digits), as next to reflex and doubled corners, 12 digits are tried, and else nothing is
/// stated: NaN, `stated_digits` 0, `converged` false.
///
/// On the quad (nearer than 1e-120 of its extent) limits from inside are extrapolated, as on a triangle; an order that
/// has none there is NaN. Mean value weights grow like the inverse distance: all their entries are NaN, `stated_digits`
/// too, and `converged` is true, as that is certain. So are those of points whose normal vanishes.
template <Scalar R>
void integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits, Result<R>& result);

}  // namespace cageproof::quadrature_ref::quad
