// SPDX-License-Identifier: MIT
#include "deformer_benchmarks.h"

#include "cageproof/deformation/deformer.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::benchmarks {
namespace {

TEST(DeformerBenchmarks, every_method_that_takes_the_cage_has_its_stages) {
  const auto what = std::make_shared<const DeformedCage>(embedded_deformed_cage("cube", 80));
  const std::vector<std::string> names = register_deformer_benchmarks(what);
  int methods = 0;
  for (const deformation::DeformMethod& method : deformation::deform_methods()) {
    if (!deformation::why_refused(method, what->cage).empty()) continue;
    ++methods;
    for (const std::string_view stage : {"prepare", "coordinates", "pose", "images"})
      EXPECT_EQ(std::ranges::count(names, fmt::format("deform/cube/{}/{}", method.name, stage)), 1) << method.name;
  }
  EXPECT_GT(methods, 10);
  for (const std::string_view stage : {"prepare", "coordinates", "pose", "images"})
    for (const std::string_view method : {"variational", "variational-harmonic", "variational-elastic"})
      EXPECT_EQ(std::ranges::count(names, fmt::format("deform/cube/{}/{}", method, stage)), 1);
  EXPECT_EQ(names.size(), 4U * (methods + 3)) << "thickness is of the plane";
}

TEST(DeformerBenchmarks, images_of_points_are_timed) {
  const auto what = std::make_shared<const DeformedCage>(embedded_deformed_cage("square", 16));
  EXPECT_EQ(what->points.size(), 16U);
  register_deformer_benchmarks(what);
  class Keep : public benchmark::BenchmarkReporter {
   public:
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& found) override { runs.insert(runs.end(), found.begin(), found.end()); }
    std::vector<Run> runs;
  } reporter;
  for (const char* method : {"green", "variational-elastic", "thickness"}) {
    reporter.runs.clear();
    const std::string name = fmt::format("^deform/square/{}/images$", method);
    ASSERT_EQ(benchmark::RunSpecifiedBenchmarks(&reporter, name), 1U) << method;
    ASSERT_EQ(reporter.runs.size(), 1U);
    ASSERT_FALSE(reporter.runs[0].error_occurred) << reporter.runs[0].error_message;
    EXPECT_GT(reporter.runs[0].counters.at("ns_per_point"), 0);
  }
}

}  // namespace
}  // namespace cageproof::benchmarks
