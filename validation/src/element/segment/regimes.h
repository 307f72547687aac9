// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation::segments {

/// How the regimes that exist for segments sample them.
std::span<const SampleMaker> regimes();

}  // namespace cageproof::validation::segments
