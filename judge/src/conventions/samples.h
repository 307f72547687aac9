// SPDX-License-Identifier: MIT
// The samples that conventions are solved on.
#pragma once

#include "cageproof/validation/sample.h"

namespace cageproof::judge {

/// Two dozen generic samples. \param far the point is moved to eight sizes from the element, where coarse rules are
/// right too \param presets parameters at their presets; else drawn from their open ranges, within 1/8 ... 8
std::vector<validation::Sample> convention_samples(const Formula& formula, std::uint64_t seed, bool far, bool presets);

/// The sample with the point exactly on the element, on a copy whose coordinates are 64ths.
validation::Sample on_element(validation::Sample sample, ElementKind element);

}  // namespace cageproof::judge
