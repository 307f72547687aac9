// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation::segments {

/// How the regimes that exist for segments sample them.
std::span<const SampleMaker> regimes();

/// Ends in small integers: in two of three turns along an axis, else anywhere in the plane.
/// \param flat the other axis
std::vector<Vec3<double>> integral(RandomStream& random, std::uint64_t turn, int flat);

// The makers of regimes that have files of their own.
void aligned(double distance, RandomStream& random, Sample& sample);

}  // namespace cageproof::validation::segments
