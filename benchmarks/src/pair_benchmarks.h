// SPDX-License-Identifier: MIT
// One benchmark for every formula, evaluation and derivative order: the time of an element-point pair.
#pragma once

#include <string>
#include <vector>

namespace cageproof::benchmarks {

/// Registers `pair/<formula>/<evaluation>/<value|gradient|hessian>` with Google Benchmark, for every formula of the
/// catalogue, its standard evaluations and the orders that these give, in double. One iteration is all pairs of
/// generic_pairs(); the gradient includes the value, the Hessian both.
///
/// Counter `ns_per_pair`: processor time of one pair, in nanoseconds.
/// \returns the names, in order of registration
std::vector<std::string> register_pair_benchmarks();

}  // namespace cageproof::benchmarks
