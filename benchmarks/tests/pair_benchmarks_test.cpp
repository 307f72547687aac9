// SPDX-License-Identifier: MIT
#include "pair_benchmarks.h"

#include "pairs.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cageproof::benchmarks {
namespace {

// Google Benchmark's register has no end; once is enough.
const std::vector<std::string>& registered() {
  static const std::vector<std::string> names = register_pair_benchmarks();
  return names;
}

TEST(PairBenchmarks, every_formula_has_its_recommended_evaluation_and_quadrature_at_every_order) {
  const std::set<std::string> names(registered().begin(), registered().end());
  EXPECT_EQ(names.size(), registered().size()) << "a name occurs twice";
  for (const Formula& formula : catalogue())
    for (const std::string_view order : {"value", "gradient", "hessian"}) {
      const auto recommended = EvaluationRegister::instance().with_role(formula.name, Role::Recommended);
      if (!recommended) continue;
      EXPECT_TRUE(names.contains(fmt::format("pair/{}/{}/{}", formula.name, recommended->name(), order)))
          << formula.name;
      const std::string start = fmt::format("pair/{}/", formula.name), end = fmt::format("/{}", order);
      const auto count = std::ranges::count_if(
          names, [&](const std::string& name) { return name.starts_with(start) && name.ends_with(end); });
      EXPECT_GE(count, 2) << formula.name << ' ' << order << ": nothing to compare with";
    }
}

class KeepRuns : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override { runs_.insert(runs_.end(), runs.begin(), runs.end()); }
  const std::vector<Run>& runs() const { return runs_; }

 private:
  std::vector<Run> runs_;
};

TEST(PairBenchmarks, counter_is_nanoseconds_a_pair) {
  const std::string name = registered().front();
  KeepRuns reporter;
  ASSERT_EQ(benchmark::RunSpecifiedBenchmarks(&reporter, "^" + name + "$"), 1U);
  ASSERT_EQ(reporter.runs().size(), 1U);
  const auto& run = reporter.runs().front();
  ASSERT_FALSE(run.error_occurred) << run.error_message;
  ASSERT_TRUE(run.counters.contains("ns_per_pair"));
  const double nanoseconds = run.cpu_accumulated_time * 1e9;
  // Two clocks, read a moment apart.
  EXPECT_NEAR(run.counters.at("ns_per_pair") * kPairCount * static_cast<double>(run.iterations) / nanoseconds, 1, 0.05);
}

}  // namespace
}  // namespace cageproof::benchmarks
