// SPDX-License-Identifier: MIT
// cageproof_bench: takes Google Benchmark's own options (--benchmark_filter, --benchmark_format=json, --benchmark_out
// ...), and three files that deformers are timed on, too: --cage=FILE --posed=FILE --points=FILE.
#include "deformer_benchmarks.h"
#include "pair_benchmarks.h"
#include "pairs.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

// Takes --<name>=value out of the arguments.
std::string taken(std::vector<char*>& arguments, const std::string& name) {
  const std::string start = "--" + name + "=";
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string argument = arguments[i];
    if (!argument.starts_with(start)) continue;
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    return argument.substr(start.size());
  }
  return "";
}

// The user's cage, where one is given.
std::shared_ptr<const cageproof::benchmarks::DeformedCage> given_cage(std::vector<char*>& arguments) {
  const std::string cage = taken(arguments, "cage"), posed = taken(arguments, "posed"),
                    points = taken(arguments, "points");
  if (cage.empty() && posed.empty() && points.empty()) return nullptr;
  if (cage.empty() || posed.empty() || points.empty())
    throw cageproof::InputError("--cage, --posed and --points are given together");
  cageproof::Cage rest = cageproof::read_cage(cage);
  const int dimension = rest.dimension();
  return std::make_shared<const cageproof::benchmarks::DeformedCage>(cageproof::benchmarks::DeformedCage{
      std::filesystem::path(cage).stem().string(), std::move(rest), cageproof::read_points(posed, dimension),
      cageproof::read_points(points, dimension)});
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cageproof::benchmarks;
  // A preset short enough to time everything in minutes; what the user says comes later and wins.
  char min_time[] = "--benchmark_min_time=0.1";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + (argc > 0 ? 1 : 0), min_time);
  std::shared_ptr<const DeformedCage> given;
  try {
    given = given_cage(arguments);
  } catch (const cageproof::InputError& error) {
    std::cerr << "cageproof_bench: " << error.what() << '\n';
    return 2;
  }
  int count = static_cast<int>(arguments.size());

  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::AddCustomContext("cageproof_version", CAGEPROOF_VERSION);
  benchmark::AddCustomContext("compiler", CAGEPROOF_COMPILER);
  benchmark::AddCustomContext("flags", CAGEPROOF_FLAGS);
  benchmark::AddCustomContext("pairs", std::to_string(kPairCount));
  register_pair_benchmarks();
  constexpr int points = 1000;
  for (const char* name : {"spiky-box", "l-shape"})
    register_deformer_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage(name, points)));
  if (given) register_deformer_benchmarks(given);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
