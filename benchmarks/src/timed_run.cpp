// SPDX-License-Identifier: MIT
#include "timed_run.h"

#include <tbb/global_control.h>

#include <chrono>
#include <ctime>

namespace cageproof::benchmarks {
namespace {

constexpr std::size_t most_bytes = std::size_t{128} << 20;

// So that tables fit in most_bytes, and vectors of points are full.
std::size_t points_a_table(const WholeCoordinates& coordinates, int order) {
  std::size_t bytes = 0;
  for (const auto& table : coordinates.tables_for(1, order))
    for (const auto& tensor : table.tensors) bytes += tensor.size() * sizeof(double);
  constexpr std::size_t lanes = 64;
  return bytes == 0 ? SIZE_MAX : std::max<std::size_t>(1, most_bytes / bytes / lanes) * lanes;
}

}  // namespace

double seconds_of(Clock clock) {
  if (clock == Clock::Processor) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double time_fill(benchmark::State& state, const WholeCoordinates& coordinates, std::span<const Vec3<double>> points,
                 int order, int threads, Clock clock) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const std::size_t block = std::min(points.size(), points_a_table(coordinates, order));
  auto tables = coordinates.tables_for(block, order);
  // Tables of constants that an evaluation makes at its first call are no part of its time.
  coordinates.fill(points.first(1), order, tables);
  double seconds = 0;
  for (auto _ : state)
    for (std::size_t first = 0; first < points.size(); first += block) {
      state.PauseTiming();
      for (auto& table : tables)
        for (int o = 0; o <= order; ++o) std::ranges::fill(table.tensors[o], 0.0);
      state.ResumeTiming();
      const double start = seconds_of(clock);
      coordinates.fill(points.subspan(first, std::min(block, points.size() - first)), order, tables);
      benchmark::DoNotOptimize(tables.data());
      benchmark::ClobberMemory();
      seconds += seconds_of(clock) - start;
    }
  return seconds;
}

void count_pairs(benchmark::State& state, double seconds, std::size_t points, std::size_t elements) {
  const auto pairs = static_cast<double>(points) * static_cast<double>(elements);
  state.counters["ns_per_pair"] = 1e9 * seconds / (static_cast<double>(state.iterations()) * pairs);
  state.counters["points"] = static_cast<double>(points);
}

}  // namespace cageproof::benchmarks
