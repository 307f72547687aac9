// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation::quads {

/// How the regimes that exist for quads sample them.
std::span<const SampleMaker> regimes();

}  // namespace cageproof::validation::quads
