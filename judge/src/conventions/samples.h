// SPDX-License-Identifier: MIT
// The samples that conventions are solved on.
#pragma once

#include "cageproof/validation/sample.h"

namespace cageproof::judge {

/// Two dozen generic samples. \param far the point is moved to eight sizes from the element, where coarse rules are
/// right too \param presets parameters at their presets; else drawn from their open ranges, within 1/8 ... 8
std::vector<validation::Sample> convention_samples(const Formula& formula, std::uint64_t seed, bool far, bool presets);

}  // namespace cageproof::judge
