// SPDX-License-Identifier: MIT
// cageproof_bench: takes Google Benchmark's own options (--benchmark_filter, --benchmark_format=json, --benchmark_out
// ...).
#include "pair_benchmarks.h"
#include "pairs.h"

#include <benchmark/benchmark.h>

#include <vector>

int main(int argc, char** argv) {
  using namespace cageproof::benchmarks;
  // A preset short enough to time everything in minutes; what the user says comes later and wins.
  char min_time[] = "--benchmark_min_time=0.1";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + (argc > 0 ? 1 : 0), min_time);
  int count = static_cast<int>(arguments.size());

  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::AddCustomContext("cageproof_version", CAGEPROOF_VERSION);
  benchmark::AddCustomContext("compiler", CAGEPROOF_COMPILER);
  benchmark::AddCustomContext("flags", CAGEPROOF_FLAGS);
  benchmark::AddCustomContext("pairs", std::to_string(kPairCount));
  register_pair_benchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
