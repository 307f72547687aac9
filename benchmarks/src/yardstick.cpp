// SPDX-License-Identifier: MIT
#include "yardstick.h"

#include "timed_run.h"
#include "yardstick_avx2.h"

#include "cageproof/core/numbers/random_stream.h"

namespace cageproof::benchmarks {

std::vector<std::string> register_yardstick() {
  std::vector<std::string> names{"yardstick/values"};
  add_benchmark(names.back(), [](benchmark::State& state) {
    if (!has_yardstick()) return state.SkipWithError("no AVX2");
    constexpr int pairs = 1024;  // small enough for the first cache
    RandomStream random(0, "yardstick", 0);
    std::vector<double> y(pairs), x(pairs), arguments(pairs / 2 * 3), angles(pairs), logarithms(arguments.size());
    // Any solid angle, and the quotients (r0 + r1 + length) / (r0 + r1 - length) of edges that are not near.
    for (double& number : y) number = random.uniform(-1, 1);
    for (double& number : x) number = random.uniform(-1, 1);
    for (double& number : arguments) number = random.uniform(1, 4);
    const double start = seconds_of(Clock::Processor);
    for (auto _ : state) {
      yardstick_values(pairs, y.data(), x.data(), arguments.data(), angles.data(), logarithms.data());
      benchmark::DoNotOptimize(angles.data());
      benchmark::DoNotOptimize(logarithms.data());
      benchmark::ClobberMemory();
    }
    count_pairs(state, seconds_of(Clock::Processor) - start, pairs, 1);
  });
  return names;
}

}  // namespace cageproof::benchmarks
