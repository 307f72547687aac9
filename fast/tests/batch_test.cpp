// SPDX-License-Identifier: MIT
// Whole coordinates against sums of closed forms in 50 digits, next to everything that a cage has.
#include "../src/batch/blocks.h"
#include "block_errors.h"
#include "small_face.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include "thinned.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace cageproof {
namespace {

using namespace block_errors;

// Beside the elements of a cage, at a distance: next to faces, edges and vertices by turns.
std::vector<Point> points_beside(const Cage& cage, const CageElements& elements, double distance, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(7, "beside/" + cage.name(), i);
    const auto k = elements.corners(random.below(static_cast<int>(elements.count())));
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    if (i % 3 >= 1) b = 0;
    if (i % 3 == 2) a = 0;
    points.push_back(k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]) + distance * cage.size() * direction(random));
  }
  return points;
}

void expect_small_errors(const Cage& cage, std::string_view kind, int order, double bound) {
  const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
  ASSERT_EQ(found.evaluation(), "batched");
  std::size_t turn = 0;  // of faces, edges and vertices where not all points are asked
  for (const int decade : {0, 1, 2, 3, 5, 7, 10, 13, 16})
    for (const Point& p : thinned(points_beside(cage, found.elements(), std::pow(10., -decade), 3), turn++))
      EXPECT_LE(block_error(found, reference, cage.size(), p, order), bound)
          << kind << " 1e-" << decade << " sizes beside " << cage.name() << ", at " << p.transpose();
}

TEST(Batched, values_next_to_everything) {
  for (const char* cage : {"cube", "twisted-bar", "thin-wall-1e-3"})
    for (const char* kind : {"green", "biharmonic", "somigliana"})
      expect_small_errors(embedded_cage(cage), kind, 0, 64);
  for (const char* cage : {"cube", "twisted-bar"}) expect_small_errors(embedded_cage(cage), "mean_value", 0, 64);
}

// Nearer than double-doubles reach: an edge, and a face whose plane is that of no axis, through the origin.
TEST(Batched, distances_beyond_double_doubles) {
  const std::vector<Face> tetrahedron{{{0, 1, 2, -1}}, {{0, 3, 1, -1}}, {{1, 3, 2, -1}}, {{2, 3, 0, -1}}};
  const Point a(0.5, 0.375, -0.25), b(-0.75, 0.5, 0.125), c = -a - b, top(0.25, 0.5, 1.5);
  const Cage face = Cage::make("face", {a, b, c, top}, tetrahedron, {.flip_inward = true});
  const Cage edge = Cage::make("edge", {a, -a, b, top}, tetrahedron, {.flip_inward = true});
  for (const Cage* cage : {&face, &edge})
    for (const auto& [kind, order] : {std::pair{"green", 0}, {"biharmonic", 0}, {"somigliana", 2}, {"mean_value", 0}}) {
      const CageCoordinates found = coordinates_of(*cage, kind, "batched"), reference = coordinates_of(*cage, kind, "");
      for (const double distance : {1e-18, 1e-25, 1e-32, 1e-40, 1e-60})
        for (int i = 0; i < 3; ++i) {
          RandomStream random(5, kind, i);
          const Point p = distance * direction(random);
          // Differences of the point and a corner keep 40 of 100 digits.
          EXPECT_LE(block_error<Mp100>(found, reference, cage->size(), p, order), 64)
              << kind << ' ' << distance << " off the " << cage->name() << ", at " << p.transpose();
        }
    }
}

// Distances from a vertex whose squares are no numbers, and one above these: values are those on the vertex.
TEST(Batched, values_at_the_least_distances) {
  std::vector<Point> vertices = embedded_cage("cube").vertices();
  for (Point& v : vertices) v = v.array() + 0.5;
  const Cage cage = embedded_cage("cube").with(vertices, embedded_cage("cube").faces());
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (const double d : {5e-324, 1e-310, 1e-200, 1e-160, 1e-120, 1e-60})
      for (const Point& p : {Point(d, d, d), Point(1, d, d), Point(d, 0.25, d), Point(0.25, 0.5, d), Point(0, d, d)}) {
        const auto f = found.at<double>(p, 0);
        const auto truth = reference.at<Mp50>(convert<Mp50>(p), 0);
        for (std::size_t b = 0; b < f.size(); ++b)
          for (std::size_t i = 0; i < f[b].value.size(); ++i)
            EXPECT_NEAR(f[b].value[i], static_cast<double>(truth[b].value[i]), 1e-14)
                << kind << " at " << p.transpose();
      }
  }
}

TEST(Batched, far_away) {
  const Cage cage = embedded_cage("twisted-bar");
  for (const auto& [kind, order] : {std::pair{"green", 0}, {"biharmonic", 0}, {"somigliana", 2}}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (int decade = 0; decade <= 9; ++decade)
      for (int i = 0; i < 2; ++i) {
        RandomStream random(9, kind, 10 * decade + i);
        const Point p = std::pow(10., decade) * cage.size() * direction(random);
        EXPECT_LE(block_error(found, reference, cage.size(), p, order), 64) << kind << ' ' << p.transpose();
      }
  }
}

// Heights over a face's plane beside it, and none.
TEST(Batched, mean_values_in_planes_of_faces) {
  const Cage cage = embedded_cage("l-block");
  const CageCoordinates found = coordinates_of(cage, "mean_value", "batched");
  const CageCoordinates reference = coordinates_of(cage, "mean_value", "");
  int asked = 0;
  for (std::size_t f = 0; f < found.elements().count(); ++f)
    for (const double height : {0., 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 2.1e-3, 4e-3, 0.01, 0.03, 0.1, 0.3}) {
      const auto k = found.elements().corners(f);
      const Point p = k[0] + 1.375 * (k[1] - k[0]) + 0.8125 * (k[2] - k[0]) + height * found.elements().normals()[f];
      if (!found.elements().touching(p).empty()) continue;
      EXPECT_LE(block_error(found, reference, cage.size(), p, 1), 64) << height << " at " << p.transpose();
      ++asked;
    }
  EXPECT_GE(asked, 60);
}

// Outside a limb little is left of what its faces sum to; within it, of phibar.
TEST(Batched, around_and_within_thin_limbs) {
  const std::vector<Face> faces{{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{0, 3, 2, -1}}, {{1, 2, 3, -1}}};
  for (const double s : {0.2, 0.1, 0.03, 1e-3, 1e-6, 1e-8}) {
    const Cage spike = Cage::make("spike", {{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, 1}}, faces, {});
    for (const auto& [kind, order] : {std::pair{"green", 1}, {"biharmonic", 1}, {"somigliana", 1}}) {
      const CageCoordinates found = coordinates_of(spike, kind, "batched"), reference = coordinates_of(spike, kind, "");
      for (int i = 0; i < 12; ++i) {
        RandomStream random(17, kind, i);
        const Point centre(s / 2, s / 2, 0.5), p = centre + random.uniform(0.3, 0.7) * direction(random);
        EXPECT_LE(block_error(found, reference, spike.size(), p, order), 64)
            << kind << ' ' << s << ' ' << p.transpose();
      }
      for (const double z : {0.0625, 0.25, 0.5}) {
        const Point p(s / 5, s / 5, z);
        EXPECT_LE(block_error(found, reference, spike.size(), p, 0), 64) << kind << ' ' << s << ' ' << p.transpose();
      }
    }
  }
}

// A box whose sides are cut into strips that end in a fan at each end.
Cage striped_box(double width, int strips) {
  std::vector<Point> ring, vertices;
  for (int i = 0; i < strips; ++i) ring.emplace_back(0, width * i / strips, 0);
  for (int i = 0; i < strips; ++i) ring.emplace_back(0, width, width * i / strips);
  for (int i = 0; i < strips; ++i) ring.emplace_back(0, width * (strips - i) / strips, width);
  for (int i = 0; i < strips; ++i) ring.emplace_back(0, 0, width * (strips - i) / strips);
  const int n = static_cast<int>(ring.size());
  for (const double x : {0., 1.})
    for (const Point& p : ring) vertices.emplace_back(x, p[1], p[2]);
  for (const double x : {0., 1.}) vertices.emplace_back(x, width / 2, width / 2);
  std::vector<Face> faces;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    for (const std::array<int, 4>& f :
         {std::array{i, n + i, n + j, -1}, {i, n + j, j, -1}, {i, j, 2 * n, -1}, {n + j, n + i, 2 * n + 1, -1}})
      faces.push_back({f});
  }
  return Cage::make("striped box", vertices, faces, {.flip_inward = true});
}

// The rounding of faces summed in double is measured against the sum over all faces, marked ones included.
TEST(Batched, around_and_within_plates_and_bars) {
  const Cage& cube = embedded_cage("cube");
  const std::vector<Face> tetrahedron{{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}};
  std::vector<Cage> cages{striped_box(0.1, 4), striped_box(1, 8)};
  for (const double s : {0.3, 0.1, 0.05, 0.01}) {
    for (const Point& sides : {Point(1, 1, s), Point(1, s, s)}) {
      std::vector<Point> vertices = cube.vertices();
      for (Point& v : vertices) v = (v - cube.vertices().front()).cwiseProduct(sides);
      cages.push_back(cube.with(vertices, cube.faces()));
    }
    cages.push_back(
        Cage::make("flat", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, s}}, tetrahedron, {.flip_inward = true}));
  }
  for (const Cage& cage : cages) {
    Point low = cage.vertices()[0], high = low;
    for (const Point& v : cage.vertices()) low = low.cwiseMin(v), high = high.cwiseMax(v);
    for (const int order : {0, 1, 2}) {
      const CageCoordinates found = coordinates_of(cage, "biharmonic", "batched");
      const CageCoordinates reference = coordinates_of(cage, "biharmonic", "");
      // Third derivatives, which a Hessian's rounding is measured by, are not asked for here.
      const double bound = order == 2 ? 512 : 64;
      for (int i = 0; i < 12; ++i) {
        RandomStream random(29, cage.name(), i);
        Point p = (low + high) / 2 + random.uniform(0.05, 0.62) * cage.size() * direction(random);
        if (i % 2 == 0)
          for (int c = 0; c < 3; ++c) p[c] = low[c] + random.uniform() * (high[c] - low[c]);
        EXPECT_LE(block_error(found, reference, cage.size(), p, order), bound)
            << cage.name() << ' ' << (high - low).transpose() << ", order " << order << " at " << p.transpose();
      }
    }
  }
}

TEST(Batched, derivatives_next_to_everything) {
  for (const char* cage : {"cube", "twisted-bar"})
    for (const char* kind : {"biharmonic", "somigliana"}) expect_small_errors(embedded_cage(cage), kind, 1, 64);
  // Third derivatives, which a Hessian's rounding is measured by, are not asked for here.
  for (const char* kind : {"green", "biharmonic", "somigliana"})
    expect_small_errors(embedded_cage("cube"), kind, 2, 128);
}

// Where hat functions are steep, differences of integrals over long edges are divided by small heights.
TEST(Batched, above_thin_faces) {
  const Cage cage = embedded_cage("fan");
  for (const char* kind : {"green", "biharmonic", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    for (int i = 0; i < 60; ++i) {
      RandomStream random(13, "thin", i);
      const Point p = random.uniform(0.1, 1) * cage.size() * direction(random);
      EXPECT_LE(block_error(found, reference, cage.size(), p, 1), 64) << kind << " " << p.transpose();
    }
  }
}

// Faces in one plane have infinite parts at their common edge, which cancel.
TEST(Batched, derivatives_next_to_an_edge_within_a_plane) {
  const Cage cage = embedded_cage("cube");
  for (const char* kind : {"green", "somigliana"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    const CageElements& elements = found.elements();
    int asked = 0;
    for (std::size_t a = 0; a < elements.count(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        if (elements.normals()[a].dot(elements.normals()[b]) < 0.99) continue;
        std::vector<int> shared;
        for (const int v : elements.vertices_of(a))
          if (std::ranges::find(elements.vertices_of(b), v) != elements.vertices_of(b).end()) shared.push_back(v);
        if (shared.size() != 2) continue;
        const Point middle = 0.375 * elements.vertices()[shared[0]] + 0.625 * elements.vertices()[shared[1]];
        for (const double distance : {1e-2, 1e-4, 1e-8, 1e-12, 1e-15}) {
          const Point p = middle - distance * elements.normals()[a];
          EXPECT_LE(block_error(found, reference, cage.size(), p, 2), 64)
              << kind << ' ' << distance << " off " << middle.transpose();
          ++asked;
        }
      }
    EXPECT_EQ(asked, 6 * 5) << kind;
  }
}

TEST(Batched, limits_on_the_cage) {
  const Cage cage = embedded_cage("cube");
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    const auto k = found.elements().corners(0);
    const Point within = 0.25 * k[0] + 0.25 * k[1] + 0.5 * k[2], on_edge = 0.25 * k[0] + 0.75 * k[1];
    for (const Point& p : {within, on_edge, k[2]}) {
      ASSERT_FALSE(found.elements().touching(p).empty());
      const auto a = found.at<double>(p, 0), b = reference.at<double>(p, 0);
      for (std::size_t block = 0; block < a.size(); ++block)
        for (std::size_t i = 0; i < a[block].value.size(); ++i)
          EXPECT_NEAR(a[block].value[i], b[block].value[i], 1e-14) << kind << " at " << p.transpose();
    }
  }
}

// A point's result does not depend on the unit, on the cage's place, or on the other points of its block.
TEST(Batched, in_other_units_and_places) {
  const Cage cage = embedded_cage("l-block");
  const auto moved = [&](double unit, const Point& by) {
    std::vector<Point> vertices = cage.vertices();
    for (Point& v : vertices) v = unit * v + by;
    return cage.with(vertices, cage.faces());
  };
  for (const double unit : {0x1p-332, 0x1p-60, 1., 0x1p60, 0x1p332, 0x1p900})
    for (const double away : {0., 0x1p20}) {
      const Point by(unit * away, -unit * away, unit * away);
      const Cage other = moved(unit, by);
      const CageCoordinates found = coordinates_of(other, "green", "batched");
      const CageCoordinates reference = coordinates_of(other, "green", "");
      for (const Point& p : {Point(0.25, 0.125, 0.375), Point(0.5, -0.25, 0.0625)})
        EXPECT_LE(block_error(found, reference, other.size(), unit * p + by, 0), 64) << unit << ' ' << away;
    }
}

TEST(Batched, applied_to_data_as_products_are) {
  const Cage cage = embedded_cage("twisted-bar");
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"}) {
    const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
    const int sets = found.blocks()[0].shape.rows == 1 ? 4 : 2;
    RandomStream random(3, kind, 0);
    CageData data{.sets = sets, .blocks = {}};
    for (const CoordinateBlock& block : found.blocks()) {
      auto& numbers = data.blocks.emplace_back(static_cast<std::size_t>(block.size) * block.shape.columns * sets);
      for (double& x : numbers) x = random.uniform(-1, 1);
    }
    std::vector<Point> points = points_beside(cage, found.elements(), 0.1, 21);
    points.push_back(cage.vertices()[0]);  // left to sums of closed forms
    const int order = std::string_view(kind) == "mean_value" ? 0 : 2;
    const AppliedTable a = found.apply(points, order, data), b = reference.apply(points, order, data);
    for (int o = 0; o <= order; ++o) {
      ASSERT_EQ(a.tensors[o].size(), b.tensors[o].size());
      // The vertex has no derivatives.
      const std::size_t asked = o == 0 ? a.tensors[o].size() : 21 * a.stride[o];
      for (std::size_t i = 0; i < asked; ++i)
        EXPECT_NEAR(a.tensors[o][i], b.tensors[o][i], 1e-11 * std::pow(10., o)) << kind << ' ' << o << ' ' << i;
    }
  }
}

TEST(Batched, the_same_bytes_for_any_number_of_threads) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageCoordinates found = coordinates_of(cage, "biharmonic", "batched");
  const std::vector<Point> points = points_beside(cage, found.elements(), 0.02, 700);
  std::vector<CoordinateTable<double>> one, two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    found.at(points, 1, one);
  }
  // Memory that is not zero, and of another size.
  found.at(std::span(points).first(5), 2, two);
  found.at(points, 1, two);
  for (std::size_t b = 0; b < one.size(); ++b) EXPECT_EQ(one[b].tensors, two[b].tensors);
}

void expect_the_same_in_every_instruction_set(const Cage& cage, double distance) {
  using namespace closed_form::batch;
  const CageElements elements(cage, false, Triangulation::Shortest);
  const Geometry geometry(elements);
  Request request{Layers::Kelvin, 2, {0.75, 0}, 0.75, {}};
  std::vector<std::size_t> begins;
  for (int order = 0; order <= 2; ++order)
    for (int block = 0; block < 2; ++block) {
      begins.push_back(request.layout.count);
      request.layout.first[order][block] = request.layout.count;
      request.layout.count += static_cast<int>(block == 0 ? elements.vertices().size() : elements.count()) * 9 *
                              (order + 1) * (order + 2) / 2;
    }
  std::vector<const Kernels*> sets{&kernels_plain};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(&kernels_avx2);
#endif
  sets.push_back(&kernels());
  const std::vector<Point> points = points_beside(cage, elements, distance, 24);
  std::vector<std::vector<double>> found;
  for (const Kernels* set : sets) {
    BlockRunner runner(geometry, elements, request, *set);
    auto& values = found.emplace_back();
    for (std::size_t p = 0; p < points.size(); p += set->lanes) {
      EXPECT_EQ(runner.run(std::span(points).subspan(p, set->lanes)), 0u);
      for (int lane = 0; lane < set->lanes; ++lane)
        for (int c = 0; c < request.layout.count; ++c) values.push_back(runner.columns()[c * set->lanes + lane]);
    }
  }
  // By the largest entry of a point's block and order.
  for (const auto& other : found)
    for (std::size_t p = 0; p < points.size(); ++p)
      for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : request.layout.count;
        double difference = 0, largest = 0;
        for (std::size_t i = p * request.layout.count + begins[k]; i < p * request.layout.count + end; ++i) {
          ASSERT_TRUE(std::isfinite(other[i])) << k << ' ' << cage.name();
          difference = std::max(difference, std::abs(other[i] - found[0][i]));
          largest = std::max(largest, std::abs(found[0][i]));
        }
        EXPECT_LE(difference, 1e-12 * largest) << k << ' ' << cage.name();
      }
}

// Next to faces, and where some of them are summed by rules of few and of many points.
TEST(Batched, every_instruction_set_of_the_machine) {
  expect_the_same_in_every_instruction_set(embedded_cage("l-block"), 1e-3);
  for (const double size : {0.2, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4})
    expect_the_same_in_every_instruction_set(with_small_face(size), 0.2);
}

TEST(Batched, kinds_that_it_does_not_know) {
  const Cage square = embedded_cage("square");
  EXPECT_THROW(coordinates_of(square, "biharmonic_affine", "batched"), InputError);
  EXPECT_EQ(coordinates_of(square, "biharmonic_affine", std::string(quickest)).evaluation(), "hybrid");
  EXPECT_EQ(coordinates_of(square, "green", std::string(quickest)).evaluation(), "batched");
  EXPECT_EQ(coordinates_of(embedded_cage("cube"), "green", std::string(quickest)).evaluation(), "batched");
}

}  // namespace
}  // namespace cageproof
