// SPDX-License-Identifier: MIT
// The cages and points that whole-cage implementations are asked at, with their truths.
#pragma once

#include "cageproof/judge/whole_cage.h"

namespace cageproof::judge {

/// One point of one cage, and its coordinates.
struct CageSample {
  CageRequest question;
  std::vector<double> truth;
  int face = -1;                        ///< that the point is on; negative for none
  std::vector<std::size_t> sizes = {};  ///< of the blocks; empty for one
};

/// Cages of a kind that keeps quads have quads. \param unit what all coordinates are multiplied with, a power of two
std::vector<CageSample> cage_samples(std::string_view kind, double unit, int dimension);

/// Coordinates of the question's first point, by the closed form. \param sizes takes those of the blocks, unless null
std::vector<double> truth_of(const CageRequest& question, std::string_view kind,
                             std::vector<std::size_t>* sizes = nullptr);

/// Two cages that show a state between calls: they differ in one vertex only. The same point in both.
std::array<CageRequest, 2> alike_cages(int dimension);

/// The corners' weights on a face that chords of the unit sphere give in place of distances. \pre it is a triangle
std::array<double, 3> chord_weights(const CageSample& sample);

}  // namespace cageproof::judge
