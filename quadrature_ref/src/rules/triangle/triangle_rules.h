// SPDX-License-Identifier: MIT
// Ways to integrate a kernel over a triangle.
//
// Every rule scales the geometry by a power of two first, and scales the tensors back by the formula's degree of
// homogeneity, so that no unit of length over- or underflows on the way. A triangle without area, or an input that
// is not finite, gives NaN. `nodes` of the statement counts the kernel evaluations. Rules of fixed size take blocks of
// points and ask for no memory at a point; results do not depend on the block.
#pragma once

#include "rules/adaptive_limits.h"
#include "cageproof/quadrature_ref/kernel.h"

namespace cageproof::quadrature_ref::triangle {

/// N x N Gauss-Legendre points on the square collapsed onto the triangle (towards corner 0): N points per side.
/// Exact for polynomials of degree 2N - 2. Converges geometrically with the ratio of the point's distance to the
/// triangle's size; useless closer than the nodes' spacing. On the triangle: whatever the nodes give (a layer's direct
/// value).
///
/// \pre 1 <= n <= 256
template <Scalar R>
void integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// The rule of [C23] (Section 5, Implementation): the triangle in three quads at its centroid and edge midpoints, n x n
/// Gauss-Legendre points on each, 3 n^2 in all. Exact for polynomials of degree 2n - 2; symmetric in the corners;
/// domain as integrate_gauss.
///
/// \pre 1 <= n <= 256
template <Scalar R>
void integrate_three_quads(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// Polar coordinates about the point of the triangle nearest to eta, tau = distance sinh w along rays and s = height
/// sinh v along edges, n-point Gauss-Legendre on panels whose length is bounded so that each gives about n digits
/// (polar_cells.h). Converges geometrically at every distance. float is computed in double and rounded. No sign of the
/// area cancels, but what cancels in the kernel itself does: next to the face, Hessians lose (size / distance)^2 units.
/// On the triangle: eta is moved against the normal (to the inside) by 1e-16 of its distance to the border; values
/// are then the limit from inside, derivatives are not to be trusted. In double about 0.2 ms, half of it geometry in
/// 200 digits (whose elementary functions ask MPFR for memory).
///
/// \pre 2 <= n <= 64
template <Scalar R>
void integrate_near_singular(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output);

/// Bisects rectangles in the variables of integrate_near_singular, 15 x 15 Gauss-Kronrod points on each, until for
/// every derivative order asked the bound (sum of the differences to the embedded 7-point rules, and of rounding) is
/// below adaptive_tolerance. `converged` is false when kAdaptiveNodeLimit or rounding prevents that: next to the face,
/// where a Hessian keeps no ten digits in double. `stated_digits` comes from the bound in both cases. float is computed
/// in double, multiprecision in 50 digits. Ends within 20 ms in double. On the triangle: eta moved inside by 1e-16 and
/// 1e-14 of its clearance; converged where the two agree to the tolerance.
/// Where entries leave the range of R, digits are those of the entries within it, and the infinities have their sign;
/// where double does not tell them, integrate_multiprecision is asked, however many nodes that takes.
template <Scalar R>
void integrate_adaptive(const Integrand& integrand, const Query<R>& query, Result<R>& result);

/// The integral to at least `digits` digits (the reference: 30, 60 for Mp100 and Mp200), norm-wise for each derivative
/// order (over the entries within R's range, where others leave it), for points at any distance. Far from the triangle
/// (1.5 longest edges) Gauss-Legendre on the collapsed square, else the cells of integrate_near_singular, each with as
/// many points and as much precision (50, 100, 200 digits) as its share of the result and the cancellation demand. Two
/// rules of different order are compared; `stated_digits` is the number of digits on which they agree (the better one
/// is returned), the least over the orders asked; `converged` is stated_digits >= 30. Costs 1 ms far away, 20 to 200 ms
/// close by, up to a second next to an edge, a few on the triangle. Closer to the face than about 1e-70 of the
/// triangle's size Hessians cancel more than 200 digits, and it says so.
///
/// On the triangle: the limit from inside along minus the normal, extrapolated from distances around 1e-15 (1e-25 for
/// 60 digits) of the point's distance to the nearest edge or corner that it does not lie on. A derivative order whose
/// extrapolations disagree has no limit: all its entries are NaN, and the statements cover the other orders; with no
/// order left, `converged` is false and `stated_digits` NaN. An order whose limit is zero is exactly zero.
template <Scalar R>
void integrate_multiprecision(const Integrand& integrand, const Query<R>& query, double digits, Result<R>& result);

}  // namespace cageproof::quadrature_ref::triangle
