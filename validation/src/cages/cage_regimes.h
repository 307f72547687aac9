// SPDX-License-Identifier: MIT
// The regimes of elements as samples of cages, with points next to, on and far from faces, edges and vertices, and
// cages moved and in other units.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/results/error_measure.h"
#include "cageproof/validation/cage_points.h"

namespace cageproof::validation {

/// The cage there. \throws InputError as Cage::make where rounding leaves no cage
Cage framed(const Cage& cage, const CageFrame& frame);

/// A point to try a cage at.
struct CageSample {
  std::string_view place;
  /// near-*: the distance in cage sizes, 0 for one unit in the last place of each coordinate; far, offset: in cage
  /// sizes; scaled: the unit; else 0.
  double parameter = 0;
  CageFrame frame = {};
  Vec3<double> point = Vec3<double>::Zero();  ///< of the framed cage
  std::uint64_t index = 0;
};

/// The places of samples, in report order: near-edge, near-face, near-vertex, on-face, on-edge, on-vertex, inside,
/// outside, aligned, far, offset, scaled.
std::vector<std::string_view> cage_places();

/// So many samples of a cage's own or moved frames, at most; the first twelve have one of each place. Sample i is a
/// function of (seed, cage, i). Left out are points meant to be on a cage on which doubles have none.
/// \param coordinates of the cage, near whose elements the points lie \param locator of the same elements
std::vector<CageSample> cage_samples(const CageCoordinates& coordinates, const Cage& cage, const CageLocator& locator,
                                     std::uint64_t seed, int count);

}  // namespace cageproof::validation
