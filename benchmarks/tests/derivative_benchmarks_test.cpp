// SPDX-License-Identifier: MIT
#include "derivative_benchmarks.h"

#include "cageproof/deformation/deformer.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::benchmarks::derivative_benchmarks_test {
namespace {

class Keep : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& found) override { runs.insert(runs.end(), found.begin(), found.end()); }
  std::vector<Run> runs;
};

TEST(DerivativeBenchmarks, every_method_with_a_derivative_has_its_products) {
  const auto what = std::make_shared<const DeformedCage>(embedded_deformed_cage("square", 16));
  const std::vector<std::string> names = register_derivative_benchmarks(what);
  std::size_t methods = 0;
  for (const deformation::DeformMethod& method : deformation::deform_methods()) {
    if (!method.has_pose_derivative || !deformation::why_refused(method, what->cage).empty()) continue;
    ++methods;
    for (const std::string_view stage : {"pose", "jvp", "vjp"})
      EXPECT_EQ(std::ranges::count(names, fmt::format("derivative/square/{}/{}", method.name, stage)), 1);
  }
  EXPECT_GT(methods, 5U);
  for (const std::string_view stage : {"rest_jvp", "rest_vjp"})
    EXPECT_EQ(std::ranges::count(names, fmt::format("derivative/square/green/{}", stage)), 1);
  for (const char* stage : {"jvp", "vjp", "rest_jvp", "rest_vjp"}) {
    Keep reporter;
    ASSERT_EQ(benchmark::RunSpecifiedBenchmarks(&reporter, fmt::format("^derivative/square/green/{}$", stage)), 1U);
    ASSERT_EQ(reporter.runs.size(), 1U);
    ASSERT_FALSE(reporter.runs[0].error_occurred) << reporter.runs[0].error_message;
    EXPECT_GT(reporter.runs[0].counters.at("ns_per_point"), 0);
    EXPECT_GT(reporter.runs[0].counters.at("ratio"), 0);
  }
}

}  // namespace
}  // namespace cageproof::benchmarks::derivative_benchmarks_test
