// SPDX-License-Identifier: MIT
#pragma once

#include "../element_sampling.h"

namespace cageproof::validation::triangles {

/// How the regimes that exist for triangles sample them.
std::span<const SampleMaker> regimes();

}  // namespace cageproof::validation::triangles
