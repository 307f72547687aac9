// SPDX-License-Identifier: MIT
#include "timed_run.h"

#include <tbb/global_control.h>

#include <chrono>
#include <ctime>

namespace cageproof::benchmarks {
namespace {

constexpr std::size_t most_bytes = std::size_t{128} << 20;

// So that tables fit in most_bytes, and vectors of points are full.
std::size_t points_a_table(const CageCoordinates& coordinates, int order) {
  std::size_t bytes = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o)
      bytes += sizeof(double) * static_cast<std::size_t>(block.size) * block.entries() *
               derivative_count(coordinates.dimension(), o);
  constexpr std::size_t lanes = 64;
  return std::max<std::size_t>(1, most_bytes / bytes / lanes) * lanes;
}

}  // namespace

double seconds_of(Clock clock) {
  if (clock == Clock::Processor) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double time_fill(benchmark::State& state, const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                 int order, int threads, Clock clock) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const std::size_t block = std::min(points.size(), points_a_table(coordinates, order));
  // The last points have tables of their own, because tables that grow again are set to zero.
  std::vector<CoordinateTable<double>> tables, rest;
  const std::size_t full = points.size() / block * block;
  const auto compute = [&] {
    for (std::size_t first = 0; first < full; first += block)
      coordinates.at(points.subspan(first, block), order, tables);
    if (full < points.size()) coordinates.at(points.subspan(full), order, rest);
  };
  // Memory, and what an evaluation makes at its first call, are no part of its time.
  coordinates.at(points.first(block), order, tables);
  if (full < points.size()) coordinates.at(points.subspan(full), order, rest);
  const double start = seconds_of(clock);
  for (auto _ : state) {
    compute();
    benchmark::DoNotOptimize(tables.data());
    benchmark::DoNotOptimize(rest.data());
    benchmark::ClobberMemory();
  }
  return seconds_of(clock) - start;
}

void count_pairs(benchmark::State& state, double seconds, std::size_t points, std::size_t elements) {
  const auto pairs = static_cast<double>(points) * static_cast<double>(elements);
  state.counters["ns_per_pair"] = 1e9 * seconds / (static_cast<double>(state.iterations()) * pairs);
  state.counters["points"] = static_cast<double>(points);
}

}  // namespace cageproof::benchmarks
