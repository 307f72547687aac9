// SPDX-License-Identifier: MIT
// Where a search for the worst input may look: the hull of the regimes.
#pragma once

#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// Limits of the domain. "Size" is the element's longest edge. How near a point is has no limit.
struct SearchDomain {
  static constexpr double smallest_size = 1e-316;
  static constexpr double largest_size = 1e300;
  static constexpr double largest_coordinate = 1e9;  ///< of corners, in sizes
  static constexpr double largest_distance = 1e111;  ///< the point's largest coordinate, in sizes
  static constexpr double smallest_aspect = 1e-11;   ///< SearchShape::aspect
  /// Exactly on the element's border the yardstick is only the truth's norm. It is fair only where the problem is well
  /// conditioned, so a search looks only there, as the on-regimes do.
  static constexpr double smallest_border_aspect = 0.25;
  static constexpr double largest_border_coordinate = 4;
};

/// Whether a sample may be proposed for a formula: an element of its kind and a point in its space, finite, not
/// degenerate, valid, within SearchDomain, parameters allowed.
bool in_search_domain(const Formula& formula, const Sample& sample);

}  // namespace cageproof::validation
