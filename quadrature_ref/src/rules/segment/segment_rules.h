// SPDX-License-Identifier: MIT
// Ways to integrate a kernel over a segment of the plane.
//
// Every rule scales the geometry by a power of two first, and scales the tensors back by the formula's degree of
// homogeneity, so that no unit of length over- or underflows on the way; kernels with the logarithm of the distance
// add the unit's own (Node::log_unit), which makes them homogeneous. A segment without length, or an input that is not
// finite, gives NaN. `nodes` of the statement counts the kernel evaluations. Points carry z = 0.
#pragma once

#include "rules/adaptive_limits.h"
#include "cageproof/quadrature_ref/kernel.h"

namespace cageproof::quadrature_ref::segment {

/// N Gauss-Legendre points, for a block of points. Exact for polynomials of degree 2N - 1. Converges geometrically with
/// the ratio of the point's distance to the segment's length; useless closer than the nodes' spacing. On the segment:
/// whatever the nodes give.
///
/// \pre 1 <= n <= 256
template <Scalar R>
void integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// The segment is cut at its point nearest to eta; along each arm tau = distance sinh w, n-point Gauss-Legendre on
/// panels whose length is bounded by the zeros of the distance, which are known, so that each gives about n digits.
/// Converges geometrically at every distance that double's range holds. float is computed in double and rounded. What
/// cancels in the kernel itself does: next to the segment, Hessians lose size / distance. On the segment: eta is moved
/// against the normal (to the inside) by 1e-16 of its distance to the ends that it does not lie on; values are then the
/// limit from inside, derivatives are not to be trusted.
///
/// \pre 2 <= n <= 64
template <Scalar R>
void integrate_near_singular(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// Bisects intervals in the variable of integrate_near_singular, 15 Gauss-Kronrod points on each, until for every
/// derivative order asked the bound (sum of the differences to the embedded 7-point rules, and of rounding) is below
/// adaptive_tolerance. `converged` is false when kAdaptiveNodeLimit or rounding prevents that: next to the segment,
/// where a Hessian keeps no ten digits in double. `stated_digits` comes from the bound in both cases. float is computed
/// in double, multiprecision in 50 digits. On the segment: eta moved inside by 1e-16 and 1e-14 of its clearance;
/// converged where the two agree to the tolerance.
/// Where entries leave the range of R, digits are those of the entries within it, and the infinities have their sign;
/// where double does not tell them, integrate_multiprecision is asked, however many nodes that takes.
template <Scalar R>
void integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result);

/// The integral to at least `digits` digits (the reference: 30, 60 for Mp100 and Mp200), norm-wise for each derivative
/// order (over the entries within R's range, where others leave it), for points at any distance, by the panels of
/// integrate_near_singular, each with as many points and as much precision (50, 100, 200 digits) as its share of the
/// result and the cancellation demand. Two sums with different panels and rules are compared; `stated_digits` is the
/// number of digits on which they agree (the better one is returned), the least over the orders asked; `converged` is
/// stated_digits >= 30. Closer to the segment than about 1e-150 of its length Hessians cancel more than 200 digits
/// leave, and it says so.
///
/// On the segment: the limit from inside along minus the normal, extrapolated from distances around 1e-15 (1e-25 for 60
/// digits) of the point's distance to the ends that it does not lie on. A derivative order whose extrapolations
/// disagree has no limit (at an end: a single layer's gradient, which grows like a logarithm): all its entries are NaN,
/// and the statements cover the other orders; with no order left, `converged` is false and `stated_digits` NaN. An
/// order whose limit is zero is exactly zero.
template <Scalar R>
void integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits, Result<R>& result);

}  // namespace cageproof::quadrature_ref::segment
