// SPDX-License-Identifier: MIT
// The same calls by one thread, and by several at once.
#pragma once

#include "defects/desk.h"

namespace cageproof::judge {

/// How many calls gave other numbers when as many threads as blocks called at once, for a fifth of a second at most or
/// two thousand calls each.
std::size_t calls_that_differ(const Evaluation& theirs, const std::vector<Block>& blocks, int order);

}  // namespace cageproof::judge
