// SPDX-License-Identifier: MIT
// Whether two sets of times differ by more than chance: the Mann-Whitney U test.
#pragma once

#include <cstddef>
#include <vector>

namespace cageproof::reports {

/// Two-sided probability that ranks of two samples of one distribution differ as much as these: exact for up to 20
/// values each without ties, else by the normal distribution with its corrections for continuity and ties.
/// Source: H. B. Mann, D. R. Whitney, Annals of Mathematical Statistics 18 (1947) 50-60. \pre neither is empty
double rank_test(const std::vector<double>& a, const std::vector<double>& b);

/// The smallest probability for so many values: that of two samples of which one lies below the other.
double least_rank_p(std::size_t a, std::size_t b);

}  // namespace cageproof::reports
