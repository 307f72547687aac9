// SPDX-License-Identifier: MIT
#pragma once

#include "../draws.h"
#include "../element_sampling.h"

namespace cageproof::validation::segments {

/// How the regimes that exist for segments sample them.
std::span<const SampleMaker> regimes();

/// Makes ends in small integers: in two of three turns along an axis, else anywhere in the plane.
/// \param flat the other axis
std::vector<Vec3<double>> integral(RandomStream& random, std::uint64_t turn, int flat);

/// A point on the first end, the inside or the line, with hat functions in 16ths: exact of corners of few bits.
Vec3<double> exact_foot(const std::vector<Vec3<double>>& corners, Feature feature, RandomStream& random);

// The makers of regimes that have files of their own.
void aligned(double distance, RandomStream& random, Sample& sample);
void tiny(double, RandomStream& random, Sample& sample);

}  // namespace cageproof::validation::segments
