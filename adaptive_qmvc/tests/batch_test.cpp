// SPDX-License-Identifier: MIT
// Quad mean value coordinates of whole cages: against their definition, and against the line form in 50 digits.
#include "../src/batch/chunk_sums.h"
#include "../src/batch/pair_sums.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include "thinned.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

namespace cageproof::adaptive_qmvc {
namespace {

using Point = Vec3<double>;

CageCoordinates coordinates_of(const Cage& cage, const std::string& evaluation) {
  return {cage, coordinate_kind_named("quad_mean_value"), CoordinateOptions{.evaluation = evaluation}};
}

double norm_of(const std::vector<Mp50>& values) {
  Mp50 squares = 0;
  for (const Mp50& x : values) squares += x * x;
  return static_cast<double>(Mp50(sqrt(squares)));
}

std::vector<Mp50> difference_of(const std::vector<double>& found, const std::vector<Mp50>& truth) {
  std::vector<Mp50> difference;
  for (std::size_t i = 0; i < truth.size(); ++i) difference.push_back(Mp50(found[i]) - truth[i]);
  return difference;
}

// |f - truth| in units of u (|truth| + size |grad truth| + |truth| (sum |w|/|sum w| - 1)): a block error, with the
// point for the only input, where a rounding of each weight w costs more far outside, where their sum cancels
// (errors.md).
double block_error(const CageCoordinates& found, const CageCoordinates& reference, double size, const Point& point) {
  const auto f = found.at<double>(point, 0)[0];
  const auto truth = reference.at<Mp50>(convert<Mp50>(point), 1)[0];
  const double slope = norm_of(truth.gradient);
  Mp50 sizes = 0;
  for (const Mp50& x : truth.value) sizes += abs(x);
  const double scale = norm_of(truth.value) * static_cast<double>(sizes) + (std::isfinite(slope) ? size * slope : 0);
  return norm_of(difference_of(f.value, truth.value)) / (unit_roundoff<double>() * scale);
}

// [T18] Eq 11 by a product rule in 50 digits, for points that are not near; a triangle is a quad with two equal
// corners.
std::vector<Mp50> integrated(const Cage& cage, const Point& point) {
  const auto& rule = gauss_legendre<Mp50>(72);
  const Vec3<Mp50> eta = convert<Mp50>(point);
  std::vector<Mp50> w(cage.vertices().size(), Mp50(0));
  for (const Face& face : cage.faces()) {
    std::array<int, 4> v = face.vertices;
    if (face.size() == 3) v[3] = v[2];
    std::array<Vec3<Mp50>, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = convert<Mp50>(cage.vertices()[v[k]]);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const Mp50 u = rule.nodes[i], t = rule.nodes[j], one = 1;
        const std::array<Mp50, 4> basis{(one - u) * (one - t), u * (one - t), u * t, (one - u) * t};
        const Vec3<Mp50> x = basis[0] * q[0] + basis[1] * q[1] + basis[2] * q[2] + basis[3] * q[3] - eta;
        const Vec3<Mp50> along = (one - t) * (q[1] - q[0]) + t * (q[2] - q[3]);
        const Vec3<Mp50> across = (one - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
        const Mp50 square = x.dot(x);
        const Mp50 weight =
            rule.weights[i] * rule.weights[j] * Vec3<Mp50>(along.cross(across)).dot(x) / (square * square);
        for (int k = 0; k < 4; ++k) w[v[k]] += basis[k] * weight;
      }
  }
  Mp50 sum = 0;
  for (const Mp50& x : w) sum += x;
  for (Mp50& x : w) x /= sum;
  return w;
}

// Two triangles and three quads, one of which is a trapezoid; two vertices are lifted out of the quads' planes.
Cage prism() {
  return Cage::make("prism",
                    {Point(0, 0, 0), Point(1, 0, 0), Point(0.25, 1, 0.125), Point(0, 0, 1), Point(1.5, 0, 1),
                     Point(0.25, 0.875, 1.25)},
                    {{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}},
                    {.flip_inward = true});
}

TEST(BatchedQuads, are_their_integral) {
  const auto expect = [](const Cage& cage, const Point& point) {
    const auto truth = integrated(cage, point);
    const auto found = coordinates_of(cage, "batched").at<double>(point, 0)[0].value;
    EXPECT_LE(norm_of(difference_of(found, truth)), 16 * unit_roundoff<double>() * norm_of(truth))
        << cage.name() << " at " << point.transpose();
  };
  // The middle, planes and lines of symmetry, planes of faces outside them.
  for (const Point& point : {Point(0, 0, 0), Point(0.125, 0, 0), Point(0.25, 0.25, 0), Point(0.11, -0.07, 0.05),
                             Point(1, 0.5, 0.25), Point(1, 0.5, 0.5), Point(-1, -1, 2), Point(3, 0, 0)})
    expect(embedded_cage("cube"), point);
  expect(embedded_cage("l-block"), Point(-0.4, -0.45, 0.03));
  expect(embedded_cage("twisted-bar"), Point(0.1, 0.05, 0.2));
  expect(prism(), Point(0.4, 0.35, 0.5));
  expect(prism(), Point(0, 0, 2));
}

// int_0^1 u^j/((u - foot)^2 + k2)^2 du from its antiderivatives by t = u - foot, in 100 digits.
std::array<Mp100, 3> moments_of(double foot, double k2) {
  const Mp100 k = sqrt(Mp100(k2)), c = foot;
  const auto at = [&](const Mp100& t) -> std::array<Mp100, 3> {
    const Mp100 square = t * t + k * k, angle = atan(t / k) / k;
    return {(t / square + angle) / (2 * k * k), -1 / (2 * square), (angle - t / square) / 2};
  };
  const std::array<Mp100, 3> from = at(-c), to = at(1 - c);
  const Mp100 m0 = to[0] - from[0], m1 = to[1] - from[1], m2 = to[2] - from[2];
  return {m0, m1 + c * m0, m2 + 2 * c * m1 + c * c * m0};
}

// From feet within the line, beyond its ends, and on them; close to its line as well, where only the form of what the
// arc tangent leaves has digits.
TEST(BatchedQuads, elementary_lines) {
  using namespace batch::CAGEPROOF_SIMD;
  for (const double foot : {-3., -1., -0.3, -0.05, 0., 0.01, 0.4, 0.5, 0.97, 1., 1.02, 1.5, 4.})
    for (const double k : {1e-15, 1e-9, 1e-5, 1e-3, 0.03, 0.1, 0.2, 0.35, 0.5, 0.7, 1., 1.5, 3.}) {
      if (foot >= 0 && foot <= 1 && k < 1e-3) continue;  // closer than lanes come
      const auto truth = moments_of(foot, k * k);
      const Moments found = elementary_moments(splat(foot), splat(k * k));
      // The scale grows with the second power of distances, times a term that is linear in them.
      const double scale = static_cast<double>(truth[0]) * (1 + foot * foot + k * k);
      EXPECT_NEAR(found.f0[0] / static_cast<double>(truth[0]), 1, 2e-14) << foot << ' ' << k;
      EXPECT_NEAR(found.f1[0], static_cast<double>(truth[1]), 8 * unit_roundoff<double>() * scale) << foot << ' ' << k;
      EXPECT_NEAR(found.f2[0], static_cast<double>(truth[2]), 8 * unit_roundoff<double>() * scale) << foot << ' ' << k;
    }
}

Point direction(RandomStream& random) {
  Point v;
  do
    for (int c = 0; c < 3; ++c) v[c] = random.uniform(-1, 1);
  while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

// Beside the faces, edges and vertices of a cage by turns, at a distance in sizes.
std::vector<Point> points_beside(const Cage& cage, const CageElements& elements, double distance, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(7, "beside/" + cage.name(), i);
    auto k = elements.corners(random.below(static_cast<int>(elements.count())));
    if (k.size() == 3) k.push_back(k[2]);
    const double a = i % 3 == 2 ? 0 : random.uniform(), b = i % 3 >= 1 ? 0 : random.uniform();
    const Point on = (1 - a) * (1 - b) * k[0] + a * (1 - b) * k[1] + a * b * k[2] + (1 - a) * b * k[3];
    points.push_back(on + distance * cage.size() * direction(random));
  }
  return points;
}

void expect_small_errors(const Cage& cage, int count) {
  const CageCoordinates found = coordinates_of(cage, "batched"), reference = coordinates_of(cage, "");
  ASSERT_EQ(found.evaluation(), "batched");
  std::size_t turn = 0;  // of faces, edges and vertices where not all points are asked
  for (const double distance : {1e1, 2., 1., 0.5, 0.25, 0.15, 0.1, 0.05, 0.02, 1e-2, 1e-4, 1e-9, 1e-13})
    for (const Point& p : thinned(points_beside(cage, found.elements(), distance, distance > 0.01 ? count : 3), turn++))
      EXPECT_LE(block_error(found, reference, cage.size(), p), 64)
          << distance << " sizes beside " << cage.name() << ", at " << p.transpose();
}

TEST(BatchedQuads, values_next_to_everything) {
  for (const char* cage : {"cube", "twisted-bar", "thin-box", "l-block", "spiky-box", "thin-wall-1e-3"})
    expect_small_errors(embedded_cage(cage), 12);
  expect_small_errors(prism(), 12);
}

// A long box: most points see its sides under an angle of more than a right one, along lines of unequal lengths.
TEST(BatchedQuads, values_next_to_long_and_uneven_quads) {
  std::vector<Point> vertices = embedded_cage("cube").vertices();
  for (Point& v : vertices) v = Point(v[0] * (v[1] > 0 ? 1 : 3), v[1], 16 * v[2] + 0.25 * v[0] * v[1]);
  expect_small_errors(embedded_cage("cube").with(vertices, embedded_cage("cube").faces()), 24);
  for (Point& v : vertices) v = Point(v[2] > 0 ? v[0] / 64 : v[0], v[1], v[2] / 8);
  expect_small_errors(embedded_cage("cube").with(vertices, embedded_cage("cube").faces()), 24);
  vertices = embedded_cage("cube").vertices();
  for (Point& v : vertices)
    if (v[2] > 0) v = Point(v[0] / 64, v[1] / 512, v[2]);
  expect_small_errors(embedded_cage("cube").with(vertices, embedded_cage("cube").faces()), 24);
}

TEST(BatchedQuads, values_on_the_cage) {
  const Cage cage = embedded_cage("cube");
  const CageCoordinates found = coordinates_of(cage, "batched"), reference = coordinates_of(cage, "");
  for (const Point& p : {Point(0.5, 0.25, 0), Point(0.5, 0.5, 0.125), Point(0.5, -0.5, 0.5), Point(0, 0, 0.5)})
    EXPECT_EQ(found.at<double>(p, 0)[0].value, reference.at<double>(p, 0)[0].value) << p.transpose();
}

TEST(BatchedQuads, values_in_any_unit) {
  const Cage cube = embedded_cage("cube");
  const Point point(0.1875, -0.3125, 0.0625);
  const auto truth = coordinates_of(cube, "").at<Mp50>(convert<Mp50>(point), 0)[0].value;
  for (const int exponent : {-1050, -332, -100, 100, 332, 1020}) {
    std::vector<Point> vertices = cube.vertices();
    for (Point& v : vertices) v *= std::ldexp(1., exponent);
    const auto found =
        coordinates_of(cube.with(vertices, cube.faces()), "batched").at<double>(point * std::ldexp(1., exponent), 0)[0];
    EXPECT_LE(norm_of(difference_of(found.value, truth)), 1e-15) << exponent;
  }
}

// Far away, where the weights' sum cancels; and with a face that is next to nothing.
TEST(BatchedQuads, values_far_away_and_beside_points) {
  for (const double side : {1., 1e-10, 1e-20, 1e-60}) {
    std::vector<Point> vertices = embedded_cage("cube").vertices();
    for (Point& v : vertices)
      if (v[2] > 0) v = Point(side * v[0], side * v[1], v[2]);
    const Cage cage = embedded_cage("cube").with(vertices, embedded_cage("cube").faces());
    const CageCoordinates found = coordinates_of(cage, "batched"), reference = coordinates_of(cage, "");
    for (const double distance : {0.1, 0.5, 1., 1e1, 1e2, 1e4, 1e6, 1e8}) {
      const Point p = distance * Point(0.3, -0.8, 0.6);
      const auto f = found.at<double>(p, 0)[0].value;
      const auto truth = reference.at<Mp50>(convert<Mp50>(p), 0)[0].value;
      Mp50 sizes = 0;
      for (const Mp50& x : truth) sizes += abs(x);
      const double scale = unit_roundoff<double>() * norm_of(truth) * static_cast<double>(sizes);
      EXPECT_LE(norm_of(difference_of(f, truth)) / scale, 64) << side << ' ' << distance;
    }
  }
}

TEST(BatchedQuads, hang_on_no_other_point_and_no_thread) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageCoordinates found = coordinates_of(cage, "batched");
  std::vector<Point> points = points_beside(cage, found.elements(), 0.2, 2500);
  points[7] = cage.vertices()[0];
  std::vector<CoordinateTable<double>> one, two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    found.at(points, 0, one);
  }
  found.at(std::span(points).first(5), 0, two);
  found.at(points, 0, two);
  EXPECT_EQ(one[0].tensors, two[0].tensors);
  for (std::size_t p = 0; p < points.size(); p += 7) {
    const auto alone = found.at<double>(points[p], 0)[0].value;
    for (std::size_t v = 0; v < alone.size(); ++v) EXPECT_EQ(alone[v], one[0].tensors[0][p * alone.size() + v]);
  }
}

TEST(BatchedQuads, apply_multiplies_the_coordinates) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageCoordinates found = coordinates_of(cage, "batched");
  std::vector<Point> points = points_beside(cage, found.elements(), 0.2, 50);
  points[7] = cage.vertices()[0];
  CageData data{.sets = 2, .blocks = {{}}};
  RandomStream random(3, "data", 0);
  for (std::size_t i = 0; i < 2 * cage.vertices().size(); ++i) data.blocks[0].push_back(random.uniform(-1, 1));
  for (const int order : {0, 1}) {
    const AppliedTable applied = found.apply(points, order, data);
    const auto tables = found.at<double>(points, order);
    for (std::size_t p = 0; p < points.size(); ++p)
      for (int o = 0; o <= order; ++o) {
        if (p == 7 && o > 0) continue;  // derivatives do not exist on the cage
        std::vector<double> sum(applied.stride[o], 0.0);
        add_products(std::span(tables[0].tensors[o]).subspan(p * tables[0].stride[o], tables[0].stride[o]),
                     found.blocks()[0], data.blocks[0], data.sets, derivative_count(3, o), sum);
        for (std::size_t i = 0; i < sum.size(); ++i)
          EXPECT_NEAR(applied.tensors[o][p * applied.stride[o] + i], sum[i], 1e-13);
      }
  }
}

TEST(BatchedQuads, derivatives_are_sums_of_line_forms) {
  const Cage cage = prism();
  const Point point(0.4, 0.35, 0.5);
  const auto found = coordinates_of(cage, "batched").at<double>(point, 2)[0];
  const auto truth = coordinates_of(cage, "").at<double>(point, 2)[0];
  EXPECT_EQ(found.gradient, truth.gradient);
  EXPECT_EQ(found.hessian, truth.hessian);
}

TEST(BatchedQuads, every_instruction_set_of_the_machine) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageElements elements(cage, true, Triangulation::Shortest);
  const batch::Geometry geometry(elements);
  std::vector<const batch::Kernels*> sets{&batch::kernels_plain};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(&batch::kernels_avx2);
#endif
  sets.push_back(&batch::kernels());
  const CageCoordinates reference = coordinates_of(cage, "");
  const std::vector<Point> points = points_beside(cage, elements, 0.15, 37);
  for (const batch::Kernels* set : sets) {
    batch::ChunkSums sums(geometry, elements, *set);
    sums.run(points);
    EXPECT_TRUE(sums.left().empty());
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto truth = reference.at<double>(points[p], 0)[0].value;
      for (std::size_t v = 0; v < truth.size(); ++v)
        EXPECT_NEAR(sums.coordinates()[v * sums.stride() + p], truth[v], 1e-14) << set->name;
    }
  }
}

TEST(BatchedQuads, are_the_quickest) {
  EXPECT_EQ(coordinates_of(embedded_cage("cube"), std::string(quickest)).evaluation(), "batched");
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
