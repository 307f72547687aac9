// SPDX-License-Identifier: MIT
// Threads, points and a counter that benchmarks of whole coordinates share.
#pragma once

#include "whole_coordinates.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <span>

namespace cageproof::benchmarks {

/// Names of derivative orders 0, 1 and 2.
inline constexpr std::array<std::string_view, 3> order_names{"value", "gradient", "hessian"};

/// So many of the points, spread evenly; all of them where there are no more.
inline std::vector<Vec3<double>> spread(const std::vector<Vec3<double>>& points, std::size_t count) {
  count = std::min(count, points.size());
  std::vector<Vec3<double>> found;
  found.reserve(count);
  for (std::size_t i = 0; i < count; ++i) found.push_back(points[i * points.size() / count]);
  return found;
}

/// The least of some numbers: a statistic of repetitions, of which whatever interrupts a processor only adds to some.
inline double least_of(const std::vector<double>& numbers) { return *std::ranges::min_element(numbers); }

/// Adds a benchmark, with the least of its repetitions.
template <class Run>
void add_benchmark(const std::string& name, Run run) {
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->Unit(benchmark::kMillisecond)
      ->ComputeStatistics("best", least_of);
}

/// Which clock: of the processor's work, for one thread, or of the wall.
enum class Clock { Processor, Wall };

/// Now, in seconds.
double seconds_of(Clock clock);

/// As often as the state asks for, computes coordinates of all points, a block after the other, on `threads` threads,
/// into tables of at most 128 MB that are there already. \returns seconds
double time_fill(benchmark::State& state, const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                 int order, int threads, Clock clock);

/// Sets the counters.
void count_pairs(benchmark::State& state, double seconds, std::size_t points, std::size_t elements);

}  // namespace cageproof::benchmarks
