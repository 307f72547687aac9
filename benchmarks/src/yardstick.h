// SPDX-License-Identifier: MIT
// A unit of time that machines share: the cost of the transcendental functions of a pair.
#pragma once

#include <string>
#include <vector>

namespace cageproof::benchmarks {

/// Registers `yardstick/values`: one arc tangent and one and a half logarithms a pair, by SLEEF at 1 ulp, on AVX2, and
/// nothing else. Counters `ns_per_pair`, processor time, and `points`, the pairs. Where the processor has no AVX2 the
/// benchmark says so. \returns the names
std::vector<std::string> register_yardstick();

}  // namespace cageproof::benchmarks
