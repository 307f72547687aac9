// SPDX-License-Identifier: MIT
// cageproof_bench: takes Google Benchmark's own options (--benchmark_filter, --benchmark_format=json, --benchmark_out
// ...), three files that deformers are timed on, too: --cage FILE --posed FILE --points FILE, and a folder of cages
// that whole coordinates are timed in: --data DIR.
#include "cage_benchmarks.h"
#include "data_cages.h"
#include "derivative_benchmarks.h"
#include "pair_benchmarks.h"
#include "pairs.h"
#include "peer_benchmarks.h"
#include "scaled_cages.h"
#include "yardstick.h"

#include "cageproof/closed_form/batch/instruction_set.h"
#include "cageproof/core/cage/mesh_io.h"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace {

using cageproof::benchmarks::DeformedCage;

struct Files {
  std::string cage, posed, points, data;
};

// The program's own options, in addition to Google Benchmark's, which has --help.
void add_options(CLI::App& app, Files& files) {
  app.set_help_flag("");
  auto* const cage = app.add_option("--cage", files.cage, "a cage that deformers are timed on, too");
  auto* const posed = app.add_option("--posed", files.posed, "its vertices elsewhere");
  auto* const points = app.add_option("--points", files.points, "points within it");
  for (auto* const option : {cage, posed, points}) option->needs(cage)->needs(posed)->needs(points);
  app.add_option("--data", files.data, "a folder of cages X_Cage.obj with meshes X.obj, for whole coordinates");
}

void print_help() {
  benchmark::PrintDefaultHelp();
  CLI::App app;
  Files files;
  add_options(app, files);
  std::cout << '\n' << app.help("cageproof_bench");
}

std::shared_ptr<const DeformedCage> cage_of(const Files& files) {
  if (files.cage.empty()) return nullptr;
  cageproof::Cage rest = cageproof::read_cage(files.cage);
  const int dimension = rest.dimension();
  return std::make_shared<const DeformedCage>(
      DeformedCage{std::filesystem::path(files.cage).stem().string(), std::move(rest),
                   cageproof::read_points(files.posed, dimension), cageproof::read_points(files.points, dimension)});
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cageproof::benchmarks;
  // A preset that times everything in minutes; the user's own options come later and win.
  char min_time[] = "--benchmark_min_time=0.1";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + (argc > 0 ? 1 : 0), min_time);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data(), print_help);
  CLI::App app;
  Files files;
  add_options(app, files);
  std::shared_ptr<const DeformedCage> given;
  std::vector<std::shared_ptr<const DeformedCage>> cages;
  try {
    app.parse(count, arguments.data());
    cageproof::closed_form::batch::instruction_set();
    given = cage_of(files);
    if (!files.data.empty()) cages = cages_in(files.data);
  } catch (const std::exception& error) {
    std::cerr << "cageproof_bench: " << error.what() << '\n';
    return 2;
  }
  benchmark::AddCustomContext("cageproof_version", CAGEPROOF_VERSION);
  benchmark::AddCustomContext("compiler", CAGEPROOF_COMPILER);
  benchmark::AddCustomContext("flags", CAGEPROOF_FLAGS);
  benchmark::AddCustomContext("pairs", std::to_string(kPairCount));
  register_pair_benchmarks();
  constexpr int points = 1000;
  for (const char* name : {"spiky-box", "l-shape"})
    register_deformer_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage(name, points)));
  if (given) register_deformer_benchmarks(given);
  for (const char* name : {"icosphere", "spiky-box", "l-shape"})
    register_derivative_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage(name, points)));
  if (given) register_derivative_benchmarks(given);
  register_yardstick();
  for (const char* name : {"icosphere", "twisted-bar", "comb"})
    register_cage_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage(name, points)));
  for (const auto& cage : cages) register_cage_benchmarks(cage);
  for (const char* name : {"icosphere", "comb"})
    register_peer_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage(name, points)));
  register_peer_benchmarks(spheres(points).cut(2));
  for (const auto& cage : cages) register_peer_benchmarks(cage);
  register_scaling_benchmarks(cages);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
