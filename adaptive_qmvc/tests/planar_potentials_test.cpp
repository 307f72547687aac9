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

Result<Mp100> evaluated(const std::string& formula, const std::vector<Vec3<Mp100>>& corners, const Vec& point,
                        int order) {
  const Evaluation evaluation = *EvaluationRegister::instance().with_role(formula, Role::Recommended);
  std::vector<Mp100> parameters;
  parameters.reserve(evaluation.formula().parameters.size());
  for (const Parameter& p : evaluation.formula().parameters) parameters.emplace_back(p.name == "nu" ? 0.25 : 1);
  Result<Mp100> result;
  evaluation(Query<Mp100>{corners, convert<Mp100>(point), order, parameters}, result);
  return result;
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
          std::vector<Mp100> found(size, Mp100(0)), expected(size, Mp100(0));
          for (int k = 0; k < 4; ++k) {
            const Vec3<Mp100> normal = (whole[(k + 1) % 4] - whole[k]).cross(whole[(k + 3) % 4] - whole[k]);
            for (std::size_t i = 0; i < size; ++i) found[i] += sqrt(Mp100(normal.dot(normal))) * tensors[k * size + i];
          }
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

}  // namespace
}  // namespace cageproof::adaptive_qmvc
