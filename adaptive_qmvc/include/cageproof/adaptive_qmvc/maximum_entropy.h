// SPDX-License-Identifier: MIT
// Maximum entropy coordinates: the positive coordinates that reproduce linear functions and are nearest to a prior.
#pragma once

#include "cageproof/core/linear.h"

#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// Maximises the entropy relative to a prior m subject to partition of unity and linear reproduction (Hormann, Sukumar 2008, Eq 5-8): coordinates
/// m_i exp(-t.(v_i - x))/Z with the t that minimises log Z, a convex function of three unknowns, by Newton's method with backtracking.
/// Stops where |sum of lambda_i (v_i - x)| is below 4 u sizes or no step lessens it, and accepts at 1e-13 sizes.
/// \param prior one a vertex, not negative, of any sum
/// \param size the cage's size, in which lengths are measured
/// \return one a vertex, zero where the prior is; NaN where there is no solution: the point is outside the convex hull of the vertices with positive
///   prior, or so near to its border that double precision finds none
std::vector<double> maximum_entropy(std::span<const Vec3<double>> vertices, std::span<const double> prior, const Vec3<double>& point, double size);

}  // namespace cageproof::adaptive_qmvc
