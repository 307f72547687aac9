// SPDX-License-Identifier: MIT
#include "pair_benchmarks.h"

#include "pairs.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <ctime>
#include <memory>

namespace cageproof::benchmarks {
namespace {

constexpr std::array<std::string_view, 3> kOrderNames{"value", "gradient", "hessian"};

// Inputs that one formula's benchmarks share.
struct Inputs {
  std::vector<Pair> pairs;
  std::vector<double> parameters;
};

std::shared_ptr<const Inputs> inputs_of(const Formula& formula) {
  auto inputs = std::make_shared<Inputs>();
  inputs->pairs = generic_pairs(formula.element);
  for (const Parameter& p : formula.parameters) inputs->parameters.push_back(p.preset);
  return inputs;
}

void run(benchmark::State& state, const Evaluation& evaluation, const Inputs& inputs, int order) {
  Result<double> result;
  // A rate of Google Benchmark's own would be shown in seconds.
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    for (const Pair& pair : inputs.pairs) {
      evaluation(Query<double>{pair.corners, pair.point, order, inputs.parameters}, result);
      benchmark::DoNotOptimize(result.of(order).data());
      benchmark::ClobberMemory();
    }
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  state.counters["ns_per_pair"] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(inputs.pairs.size()));
}

}  // namespace

std::vector<std::string> register_pair_benchmarks() {
  std::vector<std::string> names;
  const EvaluationRegister& evaluations = EvaluationRegister::instance();
  for (const Formula& formula : catalogue()) {
    const auto inputs = inputs_of(formula);
    for (const std::string& evaluation_name : evaluations.standard(formula.name)) {
      const auto evaluation = evaluations.find(formula.name, evaluation_name);
      if (!evaluation || !evaluation->supports<double>()) continue;
      for (int order = 0; order <= evaluation->max_order(); ++order) {
        names.push_back(fmt::format("pair/{}/{}/{}", formula.name, evaluation_name, kOrderNames[order]));
        benchmark::RegisterBenchmark(names.back().c_str(), [evaluation = *evaluation, inputs,
                                                            order](benchmark::State& state) {
          run(state, evaluation, *inputs, order);
        })->Unit(benchmark::kMicrosecond);
      }
    }
  }
  return names;
}

}  // namespace cageproof::benchmarks
