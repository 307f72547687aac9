// SPDX-License-Identifier: MIT
#include "peer_benchmarks.h"

#include "peers/peers.h"
#include "timed_run.h"

#include "cageproof/core/coordinates/whole_evaluation.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

namespace cageproof::benchmarks {
namespace {

struct Compared {
  std::shared_ptr<const DeformedCage> what;
  CageCoordinates coordinates;
  PeerFill peer;
  std::size_t entries;  // of a point

  Compared(std::shared_ptr<const DeformedCage> cage, const Peer& of)
      : what(std::move(cage)),
        coordinates(what->cage, coordinate_kind_named(of.kind), CoordinateOptions{.evaluation = std::string(quickest)}),
        peer(of.prepare(coordinates.elements())),
        entries(0) {
    for (const CoordinateBlock& block : coordinates.blocks())
      entries += static_cast<std::size_t>(block.size) * block.entries();
  }
};

void run_both(benchmark::State& state, const Compared& compared) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  const std::span<const Vec3<double>> points(compared.what->points);
  std::vector<double> values(points.size() * compared.entries);
  std::vector<CoordinateTable<double>> tables;
  // Memory, and what an evaluation makes at its first call, are no part of its time.
  compared.coordinates.at(points, 0, tables);
  double theirs = 0, ours = 0;
  for (auto _ : state) {
    const double start = seconds_of(Clock::Processor);
    compared.peer(points, values);
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
    const double middle = seconds_of(Clock::Processor);
    compared.coordinates.at(points, 0, tables);
    benchmark::DoNotOptimize(tables.data());
    benchmark::ClobberMemory();
    theirs += middle - start;
    ours += seconds_of(Clock::Processor) - middle;
  }
  const std::size_t elements = compared.coordinates.elements().count();
  count_pairs(state, ours, points.size(), elements);
  state.counters["cageproof_ns_per_pair"] = state.counters["ns_per_pair"];
  count_pairs(state, theirs, points.size(), elements);
  state.counters["ratio"] = theirs / ours;
}

}  // namespace

std::vector<std::string> register_peer_benchmarks(const std::shared_ptr<const DeformedCage>& what) {
  std::vector<std::string> names;
  for (const Peer& peer : peers()) {
    if (peer.dimension != what->cage.dimension()) continue;
    const auto compared = std::make_shared<const Compared>(what, peer);
    names.push_back(fmt::format("peer/{}/{}/{}", peer.kind, peer.name, what->name));
    add_benchmark(names.back(), [compared](benchmark::State& state) { run_both(state, *compared); });
  }
  return names;
}

}  // namespace cageproof::benchmarks
