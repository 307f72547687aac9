// SPDX-License-Identifier: MIT
// How long evaluations take for one pair of an element and a point, pair by pair.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/results/work_precision.h"
#include "cageproof/validation/sample.h"

#include <vector>

namespace cageproof::benchmarks {

/// How many pairs are timed whatever it takes, where there are so many.
inline constexpr std::size_t least_timed_pairs = 64;

/// Calls to time: at each sample, evaluations one after the other, each with its formula's parameters.
struct TimedPairs {
  std::vector<validation::Sample> samples;
  std::vector<std::vector<const Evaluation*>> evaluations;  ///< the same number at each sample
};

/// Sets nodes, timed and the three times: of each pair by itself, on this thread, until all are timed or `seconds` are
/// over, but of the first least_timed_pairs in any case; nodes are the mean over these, so that they do not hang on the
/// clock.
///
/// A pair is computed once before it is timed. Then it is computed in three groups of so many repetitions that a group
/// takes 20 microseconds, which makes nothing of the clock's resolution and of reading it, some tens of nanoseconds
/// together; the pair's time is the mean of the quickest group, since whatever interrupts a processor only adds. Pairs
/// that take longer than a millisecond are timed once. \pre there are samples
void time_pairs(const TimedPairs& pairs, int order, double seconds, WorkPrecisionRow& row);

}  // namespace cageproof::benchmarks
