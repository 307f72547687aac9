// SPDX-License-Identifier: MIT
// Defects of how an implementation is called, which show without any truth.
#pragma once

#include "cageproof/judge/verdict.h"

namespace cageproof::judge {

/// The first defect of calls, in the order of the table: memory outside of its own, output that is not set, results
/// that depend on earlier calls, on chance or on other threads. Where there is one, values mean nothing yet.
std::optional<FoundDefect> find_disturbed_calls(const Evaluation& theirs, std::uint64_t seed, int order);

/// The first parameter that changes nothing where it should.
std::optional<FoundDefect> find_ignored_parameter(const Evaluation& theirs, std::uint64_t seed);

}  // namespace cageproof::judge
