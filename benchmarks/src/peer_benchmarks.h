// SPDX-License-Identifier: MIT
// Times of published forms and of a public library, next to those of the evaluation that commands take.
#pragma once

#include "deformer_benchmarks.h"

namespace cageproof::benchmarks {

/// Registers `peer/<kind>/<form>/<cage>` for every form of peers() that is of the cage's dimension: values at all
/// points, by the form and by the quickest evaluation of the kind in turns, on one thread.
/// Counters: `ns_per_pair` of the form, `cageproof_ns_per_pair` of the other, processor time of a (point, element), and
/// `ratio`, the first over the second.
/// \returns the names
std::vector<std::string> register_peer_benchmarks(const std::shared_ptr<const DeformedCage>& what);

}  // namespace cageproof::benchmarks
