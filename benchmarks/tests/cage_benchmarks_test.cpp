// SPDX-License-Identifier: MIT
#include "cage_benchmarks.h"

#include "data_cages.h"
#include "scaled_cages.h"
#include "whole_coordinates.h"
#include "yardstick.h"
#include "yardstick_avx2.h"

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace cageproof::benchmarks {
namespace {

class KeepCageRuns : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& found) override { runs.insert(runs.end(), found.begin(), found.end()); }
  std::vector<Run> runs;
};

void expect_positive(const std::string& name, std::initializer_list<const char*> counters) {
  SCOPED_TRACE(name);
  KeepCageRuns reporter;
  ASSERT_EQ(benchmark::RunSpecifiedBenchmarks(&reporter, "^" + name + "$"), 1U);
  ASSERT_EQ(reporter.runs.size(), 1U);
  ASSERT_FALSE(reporter.runs[0].error_occurred) << reporter.runs[0].error_message;
  for (const char* counter : counters) EXPECT_GT(reporter.runs[0].counters.at(counter), 0) << counter;
}

const std::vector<std::string>& in_the_cube() {
  static const std::vector<std::string> names =
      register_cage_benchmarks(std::make_shared<const DeformedCage>(embedded_deformed_cage("cube", 32)));
  return names;
}

TEST(CageBenchmarks, every_kind_has_its_evaluations_at_every_order_and_applied) {
  const std::set<std::string> names(in_the_cube().begin(), in_the_cube().end());
  EXPECT_EQ(names.size(), in_the_cube().size()) << "a name occurs twice";
  const Cage cube = embedded_deformed_cage("cube", 1).cage;
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value", "quad_mean_value"}) {
    std::vector<std::string> evaluations{
        CageCoordinates(cube, coordinate_kind_named(kind), CoordinateOptions{}).evaluation()};
    for (const WholeEvaluation& whole : whole_evaluations())
      if (whole.exists(coordinate_kind_named(kind), cube)) evaluations.emplace_back(whole.name);
    for (const std::string& evaluation : evaluations)
      for (const char* order : {"value", "gradient", "hessian"})
        for (const char* how : {"", "/apply"})
          EXPECT_TRUE(names.contains(fmt::format("cage/{}/{}/{}{}/cube", kind, evaluation, order, how)))
              << kind << ' ' << evaluation << ' ' << order << how;
  }
  for (const char* kind : {"green", "biharmonic", "somigliana"})
    for (const char* rule : {"gauss-4", "gauss-8", "gauss-20", "gauss-4-plain", "gauss-8-plain", "gauss-20-plain"})
      EXPECT_TRUE(names.contains(fmt::format("cage/{}/{}/value/cube", kind, rule))) << kind << ' ' << rule;
  EXPECT_TRUE(names.contains("cage/somigliana/three-quad-7500/value/cube"));
  EXPECT_TRUE(names.contains("cage/somigliana/three-quad-7500-plain/value/cube"));
}

TEST(CageBenchmarks, counters_are_positive) {
  in_the_cube();
  for (const char* name : {"cage/green/hybrid/value/cube", "cage/somigliana/hybrid/gradient/apply/cube",
                           "cage/biharmonic/gauss-4/value/cube", "cage/biharmonic/gauss-4-plain/value/cube"})
    expect_positive(name, {"ns_per_pair", "points"});
  const Cage cube = embedded_deformed_cage("cube", 1).cage;
  for (const WholeEvaluation& whole : whole_evaluations())
    if (whole.exists(coordinate_kind_named("green"), cube))
      for (const char* how : {"", "/apply"})
        expect_positive(fmt::format("cage/green/{}/hessian{}/cube", whole.name, how), {"ns_per_pair", "points"});
}

// The rest pose is the identity where vertices and normals are reproduced; in a box, on whose triangles no area is one.
TEST(CageBenchmarks, data_of_the_rest_pose_reproduce_points) {
  DeformedCage in = embedded_deformed_cage("cube", 8);
  const Vec3<double> stretch(2, 3, 5);
  std::vector<Vec3<double>> vertices = in.cage.vertices();
  for (Vec3<double>& v : vertices) v = v.cwiseProduct(stretch);
  for (Vec3<double>& p : in.points) p = p.cwiseProduct(stretch);
  in.cage = in.cage.with(vertices, in.cage.faces());
  for (const char* name : {"green", "somigliana", "mean_value"}) {
    const CageCoordinates coordinates(in.cage, coordinate_kind_named(name), CoordinateOptions{});
    const CageData data = data_of_pose(coordinates, in.cage.vertices());
    const auto found = coordinates.apply(in.points, 0, data);
    ASSERT_EQ(found.stride[0], 3U) << name;
    for (std::size_t p = 0; p < in.points.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found.tensors[0][3 * p + c], in.points[p][c], 1e-11) << name;
  }
}

TEST(CageBenchmarks, scaling_has_three_axes_for_every_kind) {
  const std::vector<std::string> found = register_scaling_benchmarks();
  const std::set<std::string> names(found.begin(), found.end());
  EXPECT_EQ(names.size(), found.size()) << "a name occurs twice";
  for (const std::string kind : {"green", "biharmonic", "somigliana", "mean_value"})
    for (const char* of :
         {"points/batched/1", "points/batched/1000000", "points/hybrid/256", "threads/batched/2", "faces/batched/12",
          "faces/batched/81920", "faces/hybrid/5120", "faces/batched/long-20480", "faces/batched/graded-80"})
      EXPECT_TRUE(names.contains(fmt::format("scaling/{}/{}", kind, of))) << kind << ' ' << of;
  for (const std::string kind : {"quad_mean_value", "quad_green", "quad_biharmonic"})
    for (const char* of : {"points/batched/1", "threads/line_form/1", "faces/batched/98304", "faces/line_form/1536"})
      EXPECT_TRUE(names.contains(fmt::format("scaling/{}/{}", kind, of))) << kind << ' ' << of;
  expect_positive("scaling/mean_value/faces/hybrid/320", {"ns_per_pair", "points", "elements", "threads"});
  expect_positive("scaling/green/threads/hybrid/2", {"ns_per_pair", "points", "elements", "threads"});
}

// Times grow with elements only where they are what names say, and closed surfaces about the points.
TEST(CageBenchmarks, scaled_cages_hold_their_points) {
  for (const ScaledCages& cages : {cubes(64), spheres(64), long_spheres(64), graded_spheres(64)}) {
    const auto cage = cages.cut(2);
    EXPECT_EQ(cage->cage.faces().size(), cages.faces(2, true)) << cages.name(2, true);
    const CageElements elements(cage->cage, false, Triangulation::Shortest);
    EXPECT_EQ(elements.count(), cages.faces(2, false)) << cages.name(2, false);
    const WindingNumbers windings(elements);
    for (const Vec3<double>& p : cage->points) EXPECT_EQ(windings.around(p), 1) << cages.name(2, false);
  }
}

class FolderOfCages : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void write(const char* name, const std::string& text) const { std::ofstream(folder / name) << text; }

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("cageproof_data_{}", getpid());
  const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
};

TEST_F(FolderOfCages, finds_pairs_of_cage_and_mesh) {
  write("B_Cage.obj", tetrahedron);
  write("B.obj", "v 0.25 0.25 0.25\nv 0.1 0.2 0.3\n");
  write("A_Cage.obj", tetrahedron);
  write("A.obj", "v 0.5 0.25 0.125\n");
  write("A_Cage_Deformed.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\n");
  write("Lonely_Cage.obj", tetrahedron);
  write("A_Cage.txt", "no cage");
  const auto found = cages_in(folder);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]->name, "A");
  EXPECT_EQ(found[0]->posed[1], Vec3<double>(2, 0, 0));
  ASSERT_EQ(found[0]->points.size(), 1U);
  EXPECT_EQ(found[0]->points[0], Vec3<double>(0.5, 0.25, 0.125));
  EXPECT_EQ(found[1]->name, "B");
  EXPECT_EQ(found[1]->posed, found[1]->cage.vertices());
  EXPECT_EQ(found[1]->points.size(), 2U);
  const auto names = register_cage_benchmarks(found[1]);
  EXPECT_EQ(std::ranges::count(names, "cage/green/hybrid/value/B"), 1);
}

TEST_F(FolderOfCages, names_what_is_missing) {
  EXPECT_THROW(cages_in(folder), InputError) << "no pair";
  EXPECT_THROW(cages_in(folder / "nowhere"), InputError);
  write("A_Cage.obj", tetrahedron);
  write("A.obj", "v 0.5 0.25 0.125\n");
  write("A_Cage_Deformed.obj", "v 0 0 0\n");
  EXPECT_THROW(cages_in(folder), InputError) << "too few vertices";
}

TEST(Yardstick, computes_arc_tangents_and_logarithms) {
  EXPECT_EQ(register_yardstick(), std::vector<std::string>{"yardstick/values"});
  if (!has_yardstick()) GTEST_SKIP() << "no AVX2";
  std::array<double, 8> y{}, x{}, angles{};
  std::array<double, 12> arguments{}, logarithms{};
  for (int i = 0; i < 8; ++i) y[i] = i - 3.5, x[i] = 2 - i;
  for (int i = 0; i < 12; ++i) arguments[i] = 1 + i / 4.0;
  yardstick_values(8, y.data(), x.data(), arguments.data(), angles.data(), logarithms.data());
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(angles[i], std::atan2(y[i], x[i]), 1e-15);
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(logarithms[i], std::log(arguments[i]), 1e-15);
  expect_positive("yardstick/values", {"ns_per_pair", "points"});
}

}  // namespace
}  // namespace cageproof::benchmarks
