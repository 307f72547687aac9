// SPDX-License-Identifier: MIT
#pragma once

#include "../draws.h"
#include "../element_sampling.h"

namespace cageproof::validation::quads {

/// How the regimes that exist for quads sample them.
std::span<const SampleMaker> regimes();

/// Makes corners in small integers, by turns: the unit square of two axes, any in their plane, any in space.
/// \param flat the third axis
std::vector<Vec3<double>> integral(RandomStream& random, std::uint64_t turn, int flat);

/// A point on the first corner, the side that begins there, its line, the face or the surface beyond that side, with
/// parameters in eighths: exact of corners of few bits.
Vec3<double> exact_foot(const std::vector<Vec3<double>>& corners, Feature feature, RandomStream& random);

// The makers of regimes that have files of their own.
void aligned(double distance, RandomStream& random, Sample& sample);
void tiny(double, RandomStream& random, Sample& sample);

}  // namespace cageproof::validation::quads
