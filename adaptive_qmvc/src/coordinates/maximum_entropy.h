// SPDX-License-Identifier: MIT
// Maximum entropy coordinates: the positive coordinates that reproduce linear functions and are nearest to a prior.
#pragma once

#include "cageproof/core/catalogue/batch.h"

#include <span>

namespace cageproof::adaptive_qmvc {

/// Maximises the entropy relative to a prior m subject to partition of unity and linear reproduction (Hormann, Sukumar
/// 2008, Eq 5-8): coordinates m_i exp(-t.(v_i - x))/Z with the t that minimises log Z, a convex function of three
/// unknowns, by Newton's method with backtracking. Stops where |sum of lambda_i (v_i - x)| is below 4 u sizes or no
/// step lessens it, and accepts at 900 u sizes. Derivatives follow from those of the prior by differentiating the
/// conditions that t satisfies.
/// \param prior one per vertex, of any sum, with derivatives by the point up to `order`. Negative ones count as
/// constants of zero \param size the cage's size, in which lengths are measured \param result one per vertex, zero
/// where the prior is not positive; NaN where there is no solution: the point is outside the convex hull of the
/// vertices with positive prior, or so near to its border that the scalar's precision finds none. Derivatives are NaN
/// where one of the prior is
template <Scalar R>
void maximum_entropy(std::span<const Vec3<double>> vertices, const Result<R>& prior, const Vec3<R>& point, double size,
                     int order, Result<R>& result);

extern template void maximum_entropy<double>(std::span<const Vec3<double>>, const Result<double>&, const Vec3<double>&,
                                             double, int, Result<double>&);
extern template void maximum_entropy<Mp50>(std::span<const Vec3<double>>, const Result<Mp50>&, const Vec3<Mp50>&,
                                           double, int, Result<Mp50>&);
extern template void maximum_entropy<Mp100>(std::span<const Vec3<double>>, const Result<Mp100>&, const Vec3<Mp100>&,
                                            double, int, Result<Mp100>&);

}  // namespace cageproof::adaptive_qmvc
