// SPDX-License-Identifier: MIT
// Layers of whole cages that keep their quads: against their definition, and against the recommended evaluations of
// their elements in 50 digits.
#include "../src/batch/layers/layer_sums.h"
#include "../src/batch/layers/line_moments.h"

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

namespace cageproof::adaptive_qmvc::layers_batch_test {
namespace {

using Point = Vec3<double>;
constexpr std::size_t kBlocks = 4;  // phi, psi, phibar, psibar
using Blocks = std::array<std::vector<Mp50>, kBlocks>;

CageCoordinates layers_of(const Cage& cage, const std::string& evaluation, std::string_view kind = "quad_biharmonic") {
  return {cage, coordinate_kind_named(kind), CoordinateOptions{.evaluation = evaluation}};
}

double norm_of(const std::vector<Mp50>& values) {
  Mp50 squares = 0;
  for (const Mp50& x : values) squares += x * x;
  return static_cast<double>(Mp50(sqrt(squares)));
}

double distance_between(const std::vector<double>& found, const std::vector<Mp50>& truth) {
  std::vector<Mp50> difference;
  for (std::size_t i = 0; i < truth.size(); ++i) difference.push_back(Mp50(found[i]) - truth[i]);
  return norm_of(difference);
}

// The largest error of all blocks, in units of u (|truth| + size |d truth/d point|), where derivatives are asked for.
double block_error(const CageCoordinates& found, const CageCoordinates& reference, double size, const Point& point,
                   bool with_derivatives) {
  const auto f = found.at<double>(point, 0);
  const auto truth = reference.at<Mp50>(convert<Mp50>(point), with_derivatives ? 1 : 0);
  double largest = 0;
  for (std::size_t b = 0; b < truth.size(); ++b) {
    const double slope = with_derivatives ? norm_of(truth[b].gradient) : 0;
    const double scale = norm_of(truth[b].value) + (std::isfinite(slope) ? size * slope : 0);
    largest = std::max(largest, distance_between(f[b].value, truth[b].value) / (unit_roundoff<double>() * scale));
  }
  return largest;
}

// [T24] Eq 1, 3 and 7 with the measure du dv by a product rule in 50 digits, for points that are not near. A triangle
// is a quad with two equal corners, over which its one single layer has |N| for Phi_k |N_k|.
Blocks integrated(const Cage& cage, const CageElements& elements, const Point& point) {
  const auto& rule = gauss_legendre<Mp50>(72);
  const Vec3<Mp50> eta = convert<Mp50>(point);
  const Mp50 sphere = 4 * pi<Mp50>();
  Blocks blocks;
  for (std::size_t b = 0; b < kBlocks; ++b)
    blocks[b].assign(b % 2 == 0 ? cage.vertices().size() : elements.count(Owner::Normal), Mp50(0));
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const std::span<const int> of_face = elements.vertices_of(f);
    const bool quad = of_face.size() == 4;
    std::array<int, 4> v{of_face[0], of_face[1], of_face[2], quad ? of_face[3] : of_face[2]};
    std::array<Vec3<Mp50>, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = convert<Mp50>(cage.vertices()[v[k]]);
    const std::span<const int> normals = elements.shares_of(f, Owner::Normal);
    std::array<Mp50, 4> area;
    for (int k = 0; k < 4; ++k) {
      const Vec3<Mp50> corner = (q[(k + 1) % 4] - q[k]).cross(q[(k + 3) % 4] - q[k]);
      area[k] = sqrt(corner.dot(corner));
    }
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const Mp50 u = rule.nodes[i], t = rule.nodes[j], one = 1;
        const std::array<Mp50, 4> basis{(one - u) * (one - t), u * (one - t), u * t, (one - u) * t};
        const Vec3<Mp50> x = basis[0] * q[0] + basis[1] * q[1] + basis[2] * q[2] + basis[3] * q[3] - eta;
        const Vec3<Mp50> along = (one - t) * (q[1] - q[0]) + t * (q[2] - q[3]);
        const Vec3<Mp50> across = (one - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
        const Vec3<Mp50> n = along.cross(across);
        const Mp50 r = sqrt(x.dot(x)), weight = rule.weights[i] * rule.weights[j] / sphere, height = n.dot(x);
        const Mp50 single = weight / r, growing = weight * r / 2;
        const Mp50 twofold = height * single / (r * r), steady = -height * single / 2;
        for (int k = 0; k < 4; ++k) {
          blocks[0][v[k]] += basis[k] * twofold;
          blocks[2][v[k]] += basis[k] * steady;
          if (!quad) continue;
          blocks[1][normals[k]] += basis[k] * area[k] * single;
          blocks[3][normals[k]] += basis[k] * area[k] * growing;
        }
        if (quad) continue;
        const Mp50 square = sqrt(n.dot(n));
        blocks[1][normals[0]] += square * single;
        blocks[3][normals[0]] += square * growing;
      }
  }
  return blocks;
}

// Two triangles and three quads, one of which is a trapezoid; two vertices are lifted out of the quads' planes.
Cage prism() {
  return Cage::make("prism",
                    {Point(0, 0, 0), Point(1, 0, 0), Point(0.25, 1, 0.125), Point(0, 0, 1), Point(1.5, 0, 1),
                     Point(0.25, 0.875, 1.25)},
                    {{{0, 2, 1, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}},
                    {.flip_inward = true});
}

TEST(BatchedLayers, are_their_integral) {
  const auto expect = [](const Cage& cage, const Point& point) {
    const CageCoordinates batched = layers_of(cage, "batched");
    const Blocks truth = integrated(cage, batched.elements(), point);
    const auto found = batched.at<double>(point, 0);
    for (std::size_t b = 0; b < kBlocks; ++b)
      EXPECT_LE(distance_between(found[b].value, truth[b]), 16 * unit_roundoff<double>() * norm_of(truth[b]))
          << cage.name() << " at " << point.transpose() << ", block " << b;
  };
  // The middle, planes and lines of symmetry, planes of faces outside them.
  for (const Point& point : {Point(0, 0, 0), Point(0.125, 0, 0), Point(0.25, 0.25, 0), Point(0.11, -0.07, 0.05),
                             Point(1, 0.5, 0.25), Point(1, 0.5, 0.5), Point(-1, -1, 2), Point(3, 0, 0)})
    expect(embedded_cage("cube"), point);
  expect(embedded_cage("l-block"), Point(-0.4, -0.45, 0.03));
  expect(embedded_cage("twisted-bar"), Point(0.1, 0.05, 0.2));
  expect(prism(), Point(0.4, 0.35, 0.5));
  expect(prism(), Point(0, 0, 2));
  expect(prism(), Point(-5, 7, 9));
}

// int w^j/r, j = 0, 1, int w^j/r^3, j = 0, 1, 2, int w^j r, j = 0, 1, and int w^2/r along a line, w = t - origin, from
// antiderivatives by t, the length from the foot, in 100 digits.
std::array<Mp100, 8> moments_from(double from, double to, double height, double origin) {
  const Mp100 h2 = Mp100(height) * Mp100(height), o = origin;
  const auto at = [&](const Mp100& t) -> std::array<Mp100, 8> {
    const Mp100 r = sqrt(t * t + h2), logarithm = asinh(t / sqrt(h2));
    return {logarithm,         r,
            t / (h2 * r),      -1 / r,
            logarithm - t / r, (t * r + h2 * logarithm) / 2,
            r * r * r / 3,     (t * r - h2 * logarithm) / 2};
  };
  std::array<Mp100, 8> m = at(to);
  const std::array<Mp100, 8> start = at(from);
  for (std::size_t i = 0; i < m.size(); ++i) m[i] -= start[i];
  return {m[0],
          m[1] - o * m[0],
          m[2],
          m[3] - o * m[2],
          m[4] - 2 * o * m[3] + o * o * m[2],
          m[5],
          m[6] - o * m[5],
          m[7] - 2 * o * m[1] + o * o * m[0]};
}

// Feet within the line, beyond its ends and on them, close to the line and far from it; about the point that is nearest
// to the foot, and from afar about the middle, where the first moments are small.
TEST(BatchedLayers, elementary_lines) {
  using namespace batch::CAGEPROOF_SIMD;
  for (const double foot : {-300., -3., -1., -0.3, -0.05, 0., 0.01, 0.4, 0.5, 0.97, 1., 1.02, 1.5, 4., 1e4})
    for (const double height : {1e-15, 1e-9, 1e-5, 1e-3, 0.03, 0.1, 0.35, 0.7, 1., 2.5, 20., 1e3, 1e6}) {
      const double from = -foot, to = from + 1;
      if (to - from != 1) continue;
      const bool far = std::abs(foot) > 3 || height > 3;
      const double origin = far ? from + 0.5 : std::clamp(0., from, to);
      const auto truth = moments_from(from, to, height, origin);
      GrowingMoments growing;
      const LineMoments found =
          moments_about(splat(origin), splat(from), splat(to), splat(height * height), splat(to - from), &growing);
      const std::array<double, 8> m{found.inverse[0], found.step[0], found.cube[0],     found.c1[0],
                                    found.c2[0],      growing.r[0],  growing.step_r[0], growing.step2[0]};
      const auto inverse = static_cast<double>(truth[0]), cube = static_cast<double>(truth[2]);
      const auto length = static_cast<double>(truth[5]);
      // Of 1/r and 1/r^3 a few roundings; of moments a few of these, which are what basis functions are made of.
      const double scale = 16 * unit_roundoff<double>();
      const std::array<double, 8> allowed{
          scale * inverse, scale * inverse, scale * cube,   scale * cube, scale * std::min(cube, inverse),
          scale * length,  scale * length,  scale * inverse};
      for (std::size_t i = 0; i < m.size(); ++i)
        EXPECT_NEAR(m[i], static_cast<double>(truth[i]), allowed[i]) << i << ": " << foot << ' ' << height;
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
    RandomStream random(11, "layers beside/" + cage.name(), i);
    auto k = elements.corners(random.below(static_cast<int>(elements.count())));
    if (k.size() == 3) k.push_back(k[2]);
    const double a = i % 3 == 2 ? 0 : random.uniform(), b = i % 3 >= 1 ? 0 : random.uniform();
    const Point on = (1 - a) * (1 - b) * k[0] + a * (1 - b) * k[1] + a * b * k[2] + (1 - a) * b * k[3];
    points.push_back(on + distance * cage.size() * direction(random));
  }
  return points;
}

// The error of moving the point is allowed only next to the cage: elsewhere it would hide errors.
void expect_small_errors(const Cage& cage, int count, std::string_view kind = "quad_biharmonic") {
  const CageCoordinates found = layers_of(cage, "batched", kind), reference = layers_of(cage, "", kind);
  ASSERT_EQ(found.evaluation(), "batched");
  std::size_t turn = 0;  // of faces, edges and vertices where not all points are asked
  for (const double distance :
       {1e8, 1e3, 1e1, 2., 1., 0.5, 0.25, 0.15, 0.1, 0.05, 0.02, 1e-2, 1e-3, 1e-6, 1e-10, 1e-13}) {
    const bool near = distance < 0.03;
    for (const Point& p : thinned(points_beside(cage, found.elements(), distance, near ? 3 : count), turn++))
      EXPECT_LE(block_error(found, reference, cage.size(), p, near), 64)
          << distance << " sizes beside " << cage.name() << ", at " << p.transpose();
  }
}

TEST(BatchedLayers, values_next_to_everything) {
  for (const char* cage : {"cube", "thin-box", "l-block", "thin-wall-1e-3"})
    expect_small_errors(embedded_cage(cage), 6, "quad_green");
  expect_small_errors(embedded_cage("twisted-bar"), 3);
  expect_small_errors(prism(), 12);
}

// A long box: most points see its sides under an angle of more than a right one, along lines of unequal lengths.
TEST(BatchedLayers, values_next_to_long_and_uneven_quads) {
  std::vector<Point> vertices = embedded_cage("cube").vertices();
  for (Point& v : vertices) v = Point(v[0] * (v[1] > 0 ? 1 : 3), v[1], 16 * v[2] + 0.25 * v[0] * v[1]);
  expect_small_errors(embedded_cage("cube").with(vertices, embedded_cage("cube").faces()), 12);
  for (Point& v : vertices) v = Point(v[2] > 0 ? v[0] / 64 : v[0], v[1], v[2] / 8);
  expect_small_errors(embedded_cage("cube").with(vertices, embedded_cage("cube").faces()), 12);
}

// A thin plate that is turned: the normals of its faces all but cancel what a distant point in its plane sees.
TEST(BatchedLayers, oblique_plates_from_afar) {
  const Cage cube = embedded_cage("cube");
  const Point e = Point(2, 1, -2) / 3, b = Point(-2, 2, -1) / 3, n = e.cross(b);
  for (const double thickness : {0.1, 1e-3}) {
    std::vector<Point> vertices = cube.vertices();
    for (Point& v : vertices) v = v[0] * e + v[1] * b + thickness * v[2] * n;
    const Cage cage = cube.with(vertices, cube.faces());
    const CageCoordinates found = layers_of(cage, "batched"), reference = layers_of(cage, "");
    for (const double distance : {2., 1e1, 1e2, 1e4, 1e8})
      for (const double height : {0., 1e-3, 0.1}) {
        const Point p = distance * (0.8 * e - 0.6 * b + height * n);
        EXPECT_LE(block_error(found, reference, cage.size(), p, true), 64)
            << thickness << ", " << distance << ' ' << height;
      }
  }
}

TEST(BatchedLayers, values_on_the_cage) {
  const Cage cage = embedded_cage("cube");
  const CageCoordinates found = layers_of(cage, "batched"), reference = layers_of(cage, "");
  for (const Point& p : {Point(0.5, 0.25, 0), Point(0.5, 0.5, 0.5), Point(0.5, -0.5, 0.5), Point(0, 0, 0.5)})
    for (std::size_t b = 0; b < kBlocks; ++b)
      EXPECT_EQ(found.at<double>(p, 0)[b].value, reference.at<double>(p, 0)[b].value) << p.transpose();
}

TEST(BatchedLayers, values_in_any_unit) {
  const Cage cube = embedded_cage("cube");
  const Point point(0.1875, -0.3125, 0.0625);
  const auto truth = layers_of(cube, "").at<Mp50>(convert<Mp50>(point), 0);
  for (const int exponent : {-332, -200, -100, 100, 200, 332}) {
    std::vector<Point> vertices = cube.vertices();
    for (Point& v : vertices) v *= std::ldexp(1., exponent);
    const auto found =
        layers_of(cube.with(vertices, cube.faces()), "batched").at<double>(point * std::ldexp(1., exponent), 0);
    for (int b = 0; b < static_cast<int>(kBlocks); ++b) {  // of which each grows with its number as a power of length
      std::vector<double> block = found[b].value;
      for (double& x : block) x = std::ldexp(x, -b * exponent);
      EXPECT_LE(distance_between(block, truth[b].value), 1e-15) << exponent << ", block " << b;
    }
  }
}

TEST(BatchedLayers, hang_on_no_other_point_and_no_thread) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageCoordinates found = layers_of(cage, "batched");
  std::vector<Point> points = points_beside(cage, found.elements(), 0.2, 2500);
  points[7] = cage.vertices()[0];
  std::vector<CoordinateTable<double>> one, two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    found.at(points, 0, one);
  }
  found.at(std::span(points).first(5), 0, two);
  found.at(points, 0, two);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    EXPECT_EQ(one[b].tensors, two[b].tensors);
    for (std::size_t p = 0; p < points.size(); p += 7) {
      const auto alone = found.at<double>(points[p], 0)[b].value;
      for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i], one[b].tensors[0][p * alone.size() + i]);
    }
  }
}

TEST(BatchedLayers, apply_multiplies_the_coordinates) {
  const Cage cage = prism();
  const CageCoordinates found = layers_of(cage, "batched");
  std::vector<Point> points = points_beside(cage, found.elements(), 0.2, 50);
  points[7] = cage.vertices()[0];
  for (const int sets : {1, 3, 5}) {
    CageData data{.sets = sets, .blocks = {{}, {}, {}, {}}};
    RandomStream random(3, "data", 0);
    for (std::size_t b = 0; b < kBlocks; ++b)
      for (int i = 0; i < sets * found.blocks()[b].size; ++i) data.blocks[b].push_back(random.uniform(-1, 1));
    const AppliedTable applied = found.apply(points, 0, data);
    const auto tables = found.at<double>(points, 0);
    for (std::size_t p = 0; p < points.size(); ++p) {
      std::vector<double> sum(applied.stride[0], 0.0);
      for (std::size_t b = 0; b < kBlocks; ++b)
        add_products(std::span(tables[b].tensors[0]).subspan(p * tables[b].stride[0], tables[b].stride[0]),
                     found.blocks()[b], data.blocks[b], data.sets, 1, sum);
      for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(applied.tensors[0][p * applied.stride[0] + i], sum[i], 1e-13) << sets << ' ' << p;
    }
  }
}

TEST(BatchedLayers, derivatives_are_sums_of_elements) {
  const Cage cage = prism();
  const Point point(0.4, 0.35, 0.5);
  const auto found = layers_of(cage, "batched").at<double>(point, 2), truth = layers_of(cage, "").at<double>(point, 2);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    EXPECT_EQ(found[b].gradient, truth[b].gradient);
    EXPECT_EQ(found[b].hessian, truth[b].hessian);
  }
}

TEST(BatchedLayers, every_instruction_set_of_the_machine) {
  for (const Cage& cage : {embedded_cage("twisted-bar"), prism()}) {
    const CageElements elements(cage, true, Triangulation::Shortest);
    const batch::Geometry geometry(elements);
    const batch::LayerTables tables(geometry, elements, true);
    std::vector<const batch::Kernels*> sets{&batch::kernels_plain};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(&batch::kernels_avx2);
#endif
    sets.push_back(&batch::kernels());
    const CageCoordinates reference = layers_of(cage, "");
    std::vector<Point> points;
    for (const double distance : {3., 0.15, 0.01}) {
      const auto more = points_beside(cage, elements, distance, 37);
      points.insert(points.end(), more.begin(), more.end());
    }
    const std::size_t numbers = 2 * (cage.vertices().size() + elements.count(Owner::Normal));
    for (const batch::Kernels* set : sets) {
      batch::LayerSums sums(geometry, elements, tables, *set);
      sums.run(points);
      EXPECT_TRUE(sums.left().empty());
      std::vector<double> rows(points.size() * numbers);
      sums.put(0, points.size(), rows.data(), numbers);
      const double* number = rows.data();
      for (std::size_t p = 0; p < points.size(); ++p)
        for (const auto& block : reference.at<double>(points[p], 0))
          for (const double truth : block.value) {
            EXPECT_NEAR(*number, truth, 1e-14 * std::max(1., std::abs(truth))) << set->name << ' ' << p;
            ++number;
          }
    }
  }
}

// Green coordinates take the same sums, and leave out the others.
TEST(BatchedLayers, of_green_are_the_harmonic_ones) {
  for (const Cage& cage : {embedded_cage("twisted-bar"), prism()}) {
    const CageCoordinates both = layers_of(cage, "batched"), green = layers_of(cage, "batched", "quad_green");
    for (const double distance : {1e3, 1., 0.1, 1e-3, 1e-12, 0.})
      for (const Point& p : points_beside(cage, both.elements(), distance, 6)) {
        const auto all = both.at<double>(p, 0), found = green.at<double>(p, 0);
        ASSERT_EQ(found.size(), 2U);
        for (std::size_t b = 0; b < 2; ++b) EXPECT_EQ(found[b].value, all[b].value) << distance << ' ' << p.transpose();
      }
  }
}

TEST(BatchedLayers, are_the_quickest) {
  for (const char* kind : {"quad_green", "quad_biharmonic"})
    EXPECT_EQ(layers_of(embedded_cage("cube"), std::string(quickest), kind).evaluation(), "batched");
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::layers_batch_test
