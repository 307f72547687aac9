// SPDX-License-Identifier: MIT
// Planar quads are two triangles: what sums over corners with 1, x, y, z have in common with the triangles' closed
// forms, though no corner's own number has.
#include "quads.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;

const Quad<double> kUnitSquare{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0)};
const Quad<double> kTrapezoid{Vec(0, 0, 2), Vec(4, 0, 2), Vec(3, 2, 2), Vec(1, 1, 2)};
const Quad<double> kTilted{Vec(0, 0, 0), Vec(2, 0, 2), Vec(2, 3, 2), Vec(0, 1, 0)};
const Quad<double> kDartQuad{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.25, 0.25, 0), Vec(0, 1, 0)};

const std::vector<Vec> kPoints{
    Vec(0.5, 0.25, 1),    Vec(0.25, 0.25, -0x1p-20), Vec(0.125, 0.125, 0x1p-40), Vec(3, 0.25, 0),
    Vec(-1, 2, 5),        Vec(1000, 300, -700),      Vec(2, 1, 0x1p-10),         Vec(0, 0, 1),
    Vec(0.5, -0x1p-30, 0)};

using Tensors = std::vector<std::vector<Mp100>>;  // one a weight: 1, x, y, z

template <Scalar R>
Result<R> evaluated(const std::string& formula, const std::vector<Vec3<R>>& corners, const Vec3<R>& point, int order) {
  const Evaluation evaluation = *EvaluationRegister::instance().with_role(formula, Role::Recommended);
  std::vector<R> parameters;
  parameters.reserve(evaluation.formula().parameters.size());
  for (const Parameter& p : evaluation.formula().parameters) parameters.emplace_back(p.name == "nu" ? 0.25 : 1);
  Result<R> result;
  evaluation(Query<R>{corners, point, order, parameters}, result);
  return result;
}

Result<Mp100> evaluated(const std::string& formula, const std::vector<Vec3<Mp100>>& corners, const Vec& point,
                        int order) {
  return evaluated<Mp100>(formula, corners, convert<Mp100>(point), order);
}

// Adds sum_k weight(corner k) f_k for the weights 1, x, y, z.
void add_moments(const std::vector<Mp100>& tensors, const std::vector<Vec3<Mp100>>& corners, Tensors& sums) {
  const std::size_t size = tensors.size() / corners.size();
  sums.resize(4, std::vector<Mp100>(size, Mp100(0)));
  for (std::size_t k = 0; k < corners.size(); ++k)
    for (std::size_t i = 0; i < size; ++i) {
      sums[0][i] += tensors[k * size + i];
      for (int axis = 0; axis < 3; ++axis) sums[axis + 1][i] += corners[k][axis] * tensors[k * size + i];
    }
}

std::vector<Vec3<Mp100>> corners_of(const Quad<double>& q, std::initializer_list<int> which) {
  std::vector<Vec3<Mp100>> corners;
  corners.reserve(which.size());
  for (const int k : which) corners.push_back(convert<Mp100>(q[k]));
  return corners;
}

void expect_same(const std::vector<Mp100>& found, const std::vector<Mp100>& expected, const Mp100& size) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LE(abs(found[i] - expected[i]), size * Mp100("1e-28"));
}

// Sums over a quad's corners with the lengths of their normals: over a plane quad integrals by its area.
template <Scalar R>
std::vector<Mp100> times_area(const std::vector<R>& tensors, const std::vector<Vec3<Mp100>>& corners) {
  const std::size_t size = tensors.size() / 4;
  std::vector<Mp100> sums(size, Mp100(0));
  for (int k = 0; k < 4; ++k) {
    const Vec3<Mp100> normal = (corners[(k + 1) % 4] - corners[k]).cross(corners[(k + 3) % 4] - corners[k]);
    for (std::size_t i = 0; i < size; ++i) sums[i] += sqrt(Mp100(normal.dot(normal))) * Mp100(tensors[k * size + i]);
  }
  return sums;
}

Mp100 largest(const std::vector<Mp100>& tensor) {
  Mp100 most = 0;
  for (const Mp100& x : tensor) most = std::max<Mp100>(most, abs(x));
  return most;
}

// The dart's diagonal 02 lies inside it.
TEST(PlanarPotentials, double_layers_and_tractions_have_two_triangles_moments) {
  for (const std::string kernel : {"double_layer", "biharmonic_double_layer", "kelvin_traction"})
    for (const auto& q : {kUnitSquare, kTrapezoid, kTilted, kDartQuad})
      for (const Vec& point : kPoints)
        for (int order = 0; order <= 2; ++order) {
          SCOPED_TRACE(testing::Message()
                       << kernel << " order " << order << " from " << point.transpose() << " to " << q[2].transpose());
          const auto whole = corners_of(q, {0, 1, 2, 3}), first = corners_of(q, {0, 1, 2}),
                     second = corners_of(q, {0, 2, 3});
          const auto of_quad = evaluated("quad." + kernel, whole, point, order);
          Tensors found, expected;
          add_moments(of_quad.of(order), whole, found);
          for (const auto& triangle : {first, second})
            add_moments(evaluated("triangle." + kernel, triangle, point, order).of(order), triangle, expected);
          for (int w = 0; w < 4; ++w) expect_same(found[w], expected[w], largest(of_quad.of(order)) * 16);
        }
}

// With the corners' normals in place of the area: N is affine, and so |N| is in a plane where it does not turn over.
TEST(PlanarPotentials, single_layers_and_displacements_have_two_triangles_sums) {
  for (const std::string kernel : {"single_layer", "biharmonic_single_layer", "kelvin_displacement"})
    for (const auto& q : {kUnitSquare, kTrapezoid, kTilted})
      for (const Vec& point : kPoints)
        for (int order = 0; order <= 2; ++order) {
          SCOPED_TRACE(testing::Message()
                       << kernel << " order " << order << " from " << point.transpose() << " to " << q[2].transpose());
          const auto whole = corners_of(q, {0, 1, 2, 3});
          const auto tensors = evaluated("quad." + kernel, whole, point, order).of(order);
          const std::size_t size = tensors.size() / 4;
          const std::vector<Mp100> found = times_area(tensors, whole);
          std::vector<Mp100> expected(size, Mp100(0));
          for (const auto& triangle : {corners_of(q, {0, 1, 2}), corners_of(q, {0, 2, 3})}) {
            const auto part = evaluated("triangle." + kernel, triangle, point, order).of(order);
            for (std::size_t i = 0; i < size; ++i) expected[i] += part[i];
          }
          expect_same(found, expected, largest(tensors) * 64);
        }
}

TEST(PlanarPotentials, solid_angles_are_two_triangles) {
  for (const auto& q : {kUnitSquare, kTrapezoid, kTilted, kDartQuad})
    for (const Vec& point : kPoints)
      for (int order = 0; order <= 2; ++order) {
        SCOPED_TRACE(testing::Message() << "order " << order << " from " << point.transpose());
        const auto found = evaluated("quad.solid_angle", corners_of(q, {0, 1, 2, 3}), point, order).of(order);
        std::vector<Mp100> expected(found.size(), Mp100(0));
        Mp100 size = 0;
        for (const auto& triangle : {corners_of(q, {0, 1, 2}), corners_of(q, {0, 2, 3})}) {
          const auto part = evaluated("triangle.solid_angle", triangle, point, order).of(order);
          size += largest(part);
          for (std::size_t i = 0; i < part.size(); ++i) expected[i] += part[i];
        }
        expect_same(found, expected, size);
      }
}

// On the quad at coordinates that are no doubles: the integers' triangles, in units of 1e-3.
TEST(PlanarPotentials, on_quads_of_decimals_are_two_triangles) {
  const Quad<double> q{Vec(0, 1, 0), Vec(0, 0, 1), Vec(0, 0, 1000), Vec(0, 1000, 0)};
  const Mp100 unit = Mp100(1) / 1000;
  const auto whole = corners_of(q, {0, 1, 2, 3});
  std::vector<Vec3<Mp100>> decimals;
  decimals.reserve(whole.size());
  for (const auto& x : whole) decimals.emplace_back(unit * x);
  struct Kernel {
    std::string name;
    int degree;  // of the triangle's integral, in lengths
    bool by_normal;
  };
  const std::vector<Kernel> kernels{
      {"single_layer", 1, false},           {"double_layer", 0, true},    {"biharmonic_single_layer", 3, false},
      {"biharmonic_double_layer", 2, true}, {"kelvin_traction", 0, true}, {"kelvin_displacement", 1, false}};
  for (const Kernel& kernel : kernels)
    for (const Vec& point : {Vec(0, 250, 300), Vec(0, 0.75, 0.5)})
      for (int order = 0; order <= 2; ++order) {
        SCOPED_TRACE(testing::Message() << kernel.name << " order " << order << " at " << point.transpose());
        const auto result = evaluated<Mp100>("quad." + kernel.name, decimals, unit * convert<Mp100>(point), order);
        EXPECT_TRUE(result.converged);
        const auto& tensors = result.of(order);
        const std::size_t size = tensors.size() / 4;
        std::vector<Mp100> found(size, Mp100(0)), expected(size, Mp100(0));
        if (kernel.by_normal)
          for (std::size_t i = 0; i < tensors.size(); ++i) found[i % size] += tensors[i];
        else found = times_area(tensors, decimals);
        for (const auto& triangle : {corners_of(q, {0, 1, 2}), corners_of(q, {0, 2, 3})}) {
          const auto part = evaluated("triangle." + kernel.name, triangle, point, order).of(order);
          if (kernel.by_normal)
            for (std::size_t i = 0; i < part.size(); ++i) expected[i % size] += part[i];
          else
            for (std::size_t i = 0; i < size; ++i) expected[i] += part[i];
        }
        const Mp100 scale = pow(unit, Mp100(kernel.degree - order));
        for (Mp100& x : expected) x *= scale;
        expect_same(found, expected, largest(expected) * 64);
      }
  const auto weights = evaluated<Mp100>("quad.mean_value", decimals, unit * Vec3<Mp100>(0, 250, 300), 0);
  for (const Mp100& weight : weights.value) EXPECT_TRUE(isinf(weight));
}

// Where the sides across the lines all but meet, a second pair of singularities lies next to the edge's.
TEST(PlanarPotentials, on_short_edges_have_two_triangles_sums_in_double) {
  for (const double width :
       {0x1p-27, 1e-7, 7.4595434735627272e-08, 1e-8, 1e-9, 1.252449005727593e-10, 1e-10, 1.5610159744968143e-12})
    for (const double part : {0.5, 0.25})
      for (const double height : {0., 1e-20 * width, -1e-9 * width}) {
        const Quad<double> q{Vec(0, width, 0), Vec(0, 0, width), Vec(0, 0, 1), Vec(0, 1, 0)};
        const Vec point(height, part * width, width - part * width);
        const auto whole = corners_of(q, {0, 1, 2, 3});
        for (const std::string kernel : {"single_layer", "biharmonic_single_layer", "kelvin_displacement"}) {
          SCOPED_TRACE(testing::Message() << kernel << " width " << width << " from " << point.transpose());
          const auto tensors = evaluated<double>("quad." + kernel, {q[0], q[1], q[2], q[3]}, point, 0).value;
          const std::vector<Mp100> found = times_area(tensors, whole);
          std::vector<Mp100> expected(found.size(), Mp100(0));
          for (const auto& triangle : {corners_of(q, {0, 1, 2}), corners_of(q, {0, 2, 3})}) {
            const auto part_of = evaluated("triangle." + kernel, triangle, point, 0).value;
            for (std::size_t i = 0; i < found.size(); ++i) expected[i] += part_of[i];
          }
          for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_LE(abs(found[i] - expected[i]), largest(expected) * Mp100(64 * 0x1p-53));
        }
        // At a quarter the point is rounded off the edge.
        if (height != 0 || part != 0.5) continue;
        for (const double weight : evaluated<double>("quad.mean_value", {q[0], q[1], q[2], q[3]}, point, 0).value)
          EXPECT_FALSE(std::isfinite(weight)) << "width " << width << " from " << point.transpose();
      }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
