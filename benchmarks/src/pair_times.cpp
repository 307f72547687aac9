// SPDX-License-Identifier: MIT
#include "pair_times.h"

#include "summarise.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace cageproof::benchmarks {
namespace {

using PairClock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::duration<double, std::nano>;

constexpr double group_nanoseconds = 2e4, long_nanoseconds = 1e6;
constexpr int groups = 3;

// Nanoseconds of one call, as time_pairs measures it.
double nanoseconds_of(const auto& call) {
  const auto mean_of = [&](int repetitions) {
    const auto start = PairClock::now();
    for (int i = 0; i < repetitions; ++i) call();
    return Nanoseconds(PairClock::now() - start).count() / repetitions;
  };
  const double first = mean_of(1);
  if (first > long_nanoseconds) return mean_of(1);
  const int repetitions = static_cast<int>(std::ceil(group_nanoseconds / std::max(first, 20.0)));
  double least = mean_of(repetitions);
  for (int group = 1; group < groups; ++group) least = std::min(least, mean_of(repetitions));
  return least;
}

}  // namespace

void time_pairs(const TimedPairs& pairs, int order, double seconds, WorkPrecisionRow& row) {
  const auto start = PairClock::now();
  const std::size_t least = std::min(least_timed_pairs, pairs.samples.size());
  Result<double> result;
  double nodes = 0;
  std::vector<double> times;
  times.reserve(pairs.samples.size());
  for (std::size_t i = 0; i < pairs.samples.size(); ++i) {
    if (i >= least && Nanoseconds(PairClock::now() - start).count() >= 1e9 * seconds) break;
    const validation::QueryOf<double> query(pairs.samples[i], order);
    double nodes_here = 0;
    times.push_back(nanoseconds_of([&] {
      nodes_here = 0;
      for (const Evaluation* evaluation : pairs.evaluations[i]) {
        (*evaluation)(query.query(), result);
        nodes_here += static_cast<double>(result.nodes);
      }
    }));
    if (i < least) nodes += nodes_here;
  }
  row.nodes = nodes / static_cast<double>(least * pairs.evaluations.front().size());
  summarise_times(std::move(times), row);
}

}  // namespace cageproof::benchmarks
