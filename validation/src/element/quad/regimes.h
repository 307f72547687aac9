// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation::quads {

/// How the regimes that exist for quads sample them.
std::span<const SampleMaker> regimes();

/// Corners in small integers, by turns: the unit square of two axes, any in their plane, any in space.
/// \param flat the third axis
std::vector<Vec3<double>> integral(RandomStream& random, std::uint64_t turn, int flat);

// The makers of regimes that have files of their own.
void aligned(double distance, RandomStream& random, Sample& sample);

}  // namespace cageproof::validation::quads
