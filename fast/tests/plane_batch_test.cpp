// SPDX-License-Identifier: MIT
// Whole coordinates of polygons against sums of closed forms in 50 digits.
#include "../src/batch/plane_blocks.h"
#include "block_errors.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

using namespace block_errors;

constexpr int bound = 64;

std::vector<Face> around(int count) {
  std::vector<Face> sides;
  sides.reserve(count);
  for (int i = 0; i < count; ++i) sides.push_back({{i, (i + 1) % count, -1, -1}});
  return sides;
}

// A side that a vertex divides in two, another of length 1e-3, and a vertex at the origin.
Cage divided() {
  return Cage::make_polygon(
      "divided", {{-1, -0.5, 0}, {0, 0, 0}, {1, 0.5, 0}, {1, 0.501, 0}, {0.3, 0.9, 0}, {-0.7, 0.8, 0}, {-1, 0.25, 0}},
      around(7));
}

std::vector<Cage> polygons() {
  return {embedded_cage("square"), embedded_cage("l-shape"), embedded_cage("frame"), embedded_cage("comb"), divided()};
}

// Derivatives of mean values have a unit of their own, in which they are asked for by validation's tests.
int highest_order(std::string_view kind) { return kind == "mean_value" ? 0 : 2; }

void expect_small_error(const Cage& cage, std::string_view kind, const std::vector<Point>& points, int order) {
  const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
  ASSERT_EQ(found.evaluation(), "batched");
  for (const Point& p : points)
    EXPECT_LE(block_error(found, reference, cage.size(), p, order), bound)
        << kind << " of " << cage.name() << " at " << p.transpose();
}

constexpr const char* kinds[] = {"green", "biharmonic", "somigliana", "mean_value"};

TEST(PlaneBatched, next_to_sides_and_vertices) {
  for (const Cage& cage : polygons())
    for (const char* kind : kinds) {
      std::vector<Point> points;
      const auto& corner = cage.vertices();
      for (const int decade : {0, 1, 2, 3, 5, 8, 12, 15, 16})
        for (int i = 0; i < 4; ++i) {
          RandomStream random(7, cage.name(), static_cast<std::uint64_t>(10 * decade + i));
          const Face& side = cage.faces()[random.below(static_cast<int>(cage.faces().size()))];
          const double t = i % 2 == 0 ? random.uniform() : 0;
          const Point foot = (1 - t) * corner[side.vertices[0]] + t * corner[side.vertices[1]];
          points.emplace_back(foot + std::pow(10., -decade) * cage.size() * direction(random, 2));
        }
      expect_small_error(cage, kind, points, highest_order(kind));
    }
}

// A side and a vertex at the origin: distances down to those whose squares are no numbers.
TEST(PlaneBatched, at_the_least_distances) {
  const Cage side = Cage::make_polygon("side", {{-1, -0.5, 0}, {1, 0.5, 0}, {0, 2, 0}}, around(3));
  for (const Cage& cage : {side, divided()})
    for (const char* kind : kinds) {
      std::vector<Point> points;
      for (const double distance : {1e-17, 1e-25, 1e-40, 1e-80, 1e-130, 1e-200, 5e-324})
        for (const Point& towards : {Point(1, 0, 0), Point(0, -1, 0), Point(-0.5, 1, 0)})
          points.emplace_back(distance * towards);
      expect_small_error(cage, kind, points, 0);
    }
}

TEST(PlaneBatched, on_lines_and_far_away) {
  for (const Cage& cage : polygons())
    for (const char* kind : kinds) {
      std::vector<Point> points;
      const auto& corner = cage.vertices();
      for (const double t : {-1., -0.5, 1.5, 2.5, 8.}) points.emplace_back((1 - t) * corner[0] + t * corner[1]);
      // From afar sums of weights cancel.
      const std::vector<double> distances = kind == std::string_view("mean_value")
                                                ? std::vector<double>{2, 3}
                                                : std::vector<double>{2, 3, 5, 10, 1e3, 1e8};
      for (const double distance : distances) points.emplace_back(distance * cage.size() * Point(0.6, -0.8, 0));
      expect_small_error(cage, kind, points, highest_order(kind));
    }
}

TEST(PlaneBatched, on_the_polygon) {
  for (const Cage& cage : {embedded_cage("square"), divided()})
    for (const char* kind : kinds) {
      const std::vector<Point>& corner = cage.vertices();
      expect_small_error(cage, kind, {corner[1]}, 0);
      const std::vector<Point> on{(corner[0] + corner[1]) / 2, corner[1] + 0x1p-40 * (corner[2] - corner[1])};
      expect_small_error(cage, kind, on, highest_order(kind));
    }
}

TEST(PlaneBatched, in_other_units_and_places) {
  for (const double unit : {1e-100, 1e-20, 3., 1e60})
    for (const double shift : {0., 1e5}) {
      const Cage own = divided();
      std::vector<Point> vertices = own.vertices();
      for (Point& v : vertices) v = unit * Point(v + Point(shift, shift / 3, 0));
      const Cage cage = own.with(std::move(vertices), own.faces());
      for (const char* kind : kinds)
        expect_small_error(cage, kind,
                           {unit * Point(0.1 + shift, 0.4 + shift / 3, 0), unit * Point(1 + shift, 0.7 + shift / 3, 0)},
                           highest_order(kind));
    }
}

TEST(PlaneBatched, applied_to_data_as_products_are) {
  const Cage cage = embedded_cage("l-shape");
  for (const char* kind : kinds) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    RandomStream random(3, kind, 0);
    CageData data{.sets = 2, .blocks = {}};
    for (const CoordinateBlock& block : found.blocks()) {
      auto& numbers = data.blocks.emplace_back(static_cast<std::size_t>(block.size) * block.shape.columns * data.sets);
      for (double& x : numbers) x = random.uniform(-1, 1);
    }
    std::vector<Point> points;
    points.reserve(21);
    for (int i = 0; i < 21; ++i) points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const int order = highest_order(kind);
    const AppliedTable a = found.apply(points, order, data), b = reference.apply(points, order, data);
    for (int o = 0; o <= order; ++o) {
      ASSERT_EQ(a.tensors[o].size(), b.tensors[o].size());
      for (std::size_t i = 0; i < a.tensors[o].size(); ++i)
        EXPECT_NEAR(a.tensors[o][i], b.tensors[o][i], 1e-12 * std::max(1., std::abs(b.tensors[o][i])))
            << kind << ' ' << o << ' ' << i;
    }
  }
}

TEST(PlaneBatched, every_instruction_set_of_the_machine) {
  using namespace closed_form::batch;
  const Cage cage = embedded_cage("star");
  const CageElements elements(cage, false, Triangulation::Shortest);
  const Polygon polygon(elements);
  Request request{Layers::Harmonic, 0, {0, 0}, 0, {}};
  request.layout.first[0][1] = static_cast<int>(elements.vertices().size());
  request.layout.count = static_cast<int>(elements.vertices().size() + elements.count());
  std::vector<const Kernels*> sets{&kernels_plain};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(&kernels_avx2);
#endif
  sets.push_back(&kernels());
  std::vector<Point> points;
  points.reserve(24);
  RandomStream random(1, "sets", 0);
  for (int i = 0; i < 24; ++i) points.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2), 0);
  std::vector<std::vector<double>> found;
  for (const Kernels* set : sets) {
    PlaneRunner runner(polygon, elements, request, *set);
    auto& values = found.emplace_back();
    for (std::size_t p = 0; p < points.size(); p += set->lanes) {
      EXPECT_EQ(runner.run(std::span(points).subspan(p, set->lanes)), 0u);
      for (int lane = 0; lane < set->lanes; ++lane)
        for (int c = 0; c < request.layout.count; ++c) values.push_back(runner.columns()[c * set->lanes + lane]);
    }
  }
  for (const auto& other : found)
    for (std::size_t i = 0; i < other.size(); ++i) EXPECT_NEAR(other[i], found[0][i], 1e-13);
}

}  // namespace
}  // namespace cageproof
