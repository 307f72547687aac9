// SPDX-License-Identifier: MIT
// How many Gauss-Legendre points a segment takes far away: as few as an error bound allows.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

#include <cmath>

namespace cageproof::fast::segment {

using namespace closed_form;
using namespace closed_form::segment;
using closed_form::segment::Scalar;

/// log10 of a bound of the relative error of n points for the hat functions over z or z^2. The integrand is analytic
/// within the ellipse about the ends on which the point lies, whose half axes are (rho + 1/rho)/2 and (rho - 1/rho)/2
/// half lengths, and the rule's error falls like rho^(-2n). One degree of those that the rule is exact for goes to the
/// hat function, and each power of 1/z may raise the integrand on a slightly smaller ellipse by n.
inline double log10_far_error(int n, double rho) {
  return std::log10(4 * (1.0 + n) * (1.0 + n)) - (2 * n - 1) * std::log10(rho);
}

/// The fewest points for a quarter of a rounding. \pre the point is farther away than the segment's length
template <Scalar R>
int far_points(const Frame<R>& f) {
  const double sum = static_cast<double>((f.r[0] + f.r[1]) / f.length), rho = sum + std::sqrt(sum * sum - 1);
  int n = 2;
  const double rounding = std::log10(0x1p-55);
  while (log10_far_error(n, rho) > rounding) ++n;
  return n;
}

}  // namespace cageproof::fast::segment
