// SPDX-License-Identifier: MIT
// Where a search for the worst input may look: the hull of the regimes.
#pragma once

#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// Limits of the domain. "Size" is the element's longest edge.
struct SearchDomain {
  static constexpr double smallest_size = 1e-101;
  static constexpr double largest_size = 1e101;
  static constexpr double largest_coordinate = 1e9;  ///< in sizes; offsets and distances
  static constexpr double smallest_aspect = 1e-11;   ///< SearchShape::aspect
  /// In sizes, from corners, edges' lines and plane or bilinear surface; or exactly zero. Nearer, the yardstick's
  /// differences would cross a singularity.
  static constexpr double smallest_distance = 1e-20;
  /// Exactly on the element's border the yardstick is the truth's norm alone. It is fair where the problem is well
  /// conditioned: there only, as the on-regimes do, may a search look.
  static constexpr double smallest_border_aspect = 0.25;
  static constexpr double largest_border_coordinate = 4;
};

/// Whether a sample may be proposed for a formula: an element of its kind and a point in its space, finite, not
/// degenerate, valid, within SearchDomain, parameters allowed. Zero area and zero distance are decided with 200 digits,
/// exactly over 100 decades.
bool in_search_domain(const Formula& formula, const Sample& sample);

}  // namespace cageproof::validation
