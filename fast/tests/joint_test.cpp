// SPDX-License-Identifier: MIT
// Several formulas evaluated together give the same bits as each by itself, whatever they share.
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/random_stream.h"

#include "thinned.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::joint_test {
namespace {

using Vec = Vec3<double>;

struct Input {
  std::vector<Vec> corners;
  std::vector<Vec> points;
};

Vec random_point(RandomStream& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; }

// Points of all regimes about a triangle: anywhere, next to it on every scale, on its border and its plane, far away.
std::vector<Input> triangle_inputs(int count) {
  std::vector<Input> inputs;
  for (int i = 0; i < count; ++i) {
    RandomStream random(41, "joint", i);
    Vec a = random_point(random), b = random_point(random), c = random_point(random);
    if (i % 4 == 1) c = a + random.uniform() * (b - a) + std::pow(10.0, -1 - i % 10) * (c - a);  // sliver
    if (i % 4 == 2) b = a + std::pow(10.0, -1 - i % 10) * (b - a);                               // needle
    if (i % 4 == 3) a = Vec(0, 0, 0), b = Vec(1, 0, 0), c = Vec(0, 1, 0);
    const Vec n = (b - a).cross(c - a).normalized(), middle = (a + b + c) / 3;
    std::vector<Vec> points{random_point(random),
                            Vec(middle + std::pow(10.0, -1 - i % 16) * n),
                            a,
                            Vec((a + b) / 2),
                            Vec(b + std::pow(10.0, -1 - i % 16) * random_point(random)),
                            Vec(0.25 * a + 0.25 * b + 0.5 * c),
                            Vec(2 * b - a),
                            Vec(middle + 3 * random_point(random))};
    for (int k = 1; k <= 8; k += 2) points.push_back(middle + std::pow(10.0, k) * random_point(random));
    inputs.push_back({{a, b, c}, points});
  }
  return thinned(std::move(inputs));
}

std::vector<Input> segment_inputs(int count) {
  std::vector<Input> inputs;
  for (int i = 0; i < count; ++i) {
    RandomStream random(42, "joint", i);
    const auto flat = [](Vec v) { return Vec(v[0], v[1], 0); };
    const Vec a = i % 2 ? Vec(0, 0, 0) : flat(random_point(random)),
              b = i % 2 ? Vec(1, 0, 0) : flat(random_point(random));
    inputs.push_back({{a, b},
                      {flat(random_point(random)), a, b, Vec((a + b) / 2), Vec(2 * b - a),
                       flat(1e5 * random_point(random)), flat(a + 1e-9 * random_point(random))}});
  }
  return thinned(std::move(inputs));
}

template <Scalar R>
bool same_bits(const R& a, const R& b) {
  if constexpr (is_multiprecision<R>) return (isnan(a) && isnan(b)) || (a == b && signbit(a) == signbit(b));
  else return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// The results of a group for a block of points. Each member and order has the tensors of one point after another.
template <Scalar R>
std::vector<std::array<std::vector<R>, 3>> together(const std::vector<Evaluation>& group, const Batch<R>& batch) {
  std::vector<std::array<std::vector<R>, 3>> found(group.size());
  std::vector<const Evaluation*> members;
  std::vector<BatchOutput<R>> outputs;
  for (std::size_t m = 0; m < group.size(); ++m) {
    const Formula& formula = group[m].formula();
    BatchOutput<R> output{.entries = static_cast<std::size_t>(formula.shape.entries()), .dim = formula.dim()};
    for (int o = 0; o <= batch.order; ++o) {
      output.stride[o] = formula.components() * derivative_count(formula.dim(), o);
      found[m][o].assign(batch.points.size() * output.stride[o], R(0));
      output.tensors[o] = found[m][o].data();
    }
    members.push_back(&group[m]);
    outputs.push_back(output);
  }
  Evaluation::together<R>(members, batch, outputs);
  return found;
}

template <Scalar R>
void expect_equal(const std::vector<Evaluation>& group, const std::vector<Input>& inputs,
                  std::span<const R> parameters) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::vector<Vec3<R>> corners, points;
    for (const Vec& v : inputs[i].corners) corners.push_back(convert<R>(v));
    for (const Vec& v : inputs[i].points) points.push_back(convert<R>(v));
    for (int order = 0; order <= 2; ++order)
      for (const bool finite_part : {false, true}) {
        const auto found = together<R>(group, {corners, points, order, parameters, finite_part});
        for (std::size_t m = 0; m < group.size(); ++m)
          for (std::size_t p = 0; p < points.size(); ++p) {
            Result<R> alone;
            group[m](Query<R>{corners, points[p], order, parameters, finite_part}, alone);
            for (int o = 0; o <= order; ++o)
              for (std::size_t k = 0; k < alone.of(o).size(); ++k)
                ASSERT_TRUE(same_bits<R>(alone.of(o)[k], found[m][o][p * alone.of(o).size() + k]))
                    << group[m].formula().name << ", input " << i << ", point " << p << ", order " << o << " of "
                    << order << ", entry " << k << ": " << alone.of(o)[k] << " alone, "
                    << found[m][o][p * alone.of(o).size() + k] << " together";
          }
      }
  }
}

std::vector<Evaluation> group_of(std::initializer_list<const char*> formulas, Role role) {
  std::vector<Evaluation> group;
  for (const char* name : formulas) group.push_back(*EvaluationRegister::instance().with_role(name, role));
  return group;
}

void expect_equal_in_all_scalars(std::initializer_list<const char*> formulas, const std::vector<Input>& inputs,
                                 int wide_inputs, std::array<double, 2> given = {1.5, 0.25}) {
  const std::vector<Input> few(inputs.begin(), inputs.begin() + std::max(2, wide_inputs / test_stride()));
  for (const Role role : {Role::Recommended, Role::ClosedForm}) {
    const auto group = group_of(formulas, role);
    for (const ScalarKind kind : scalar_kinds)
      with_scalar(kind, [&]<Scalar R>() {
        const std::array<R, 2> parameters{R(given[0]), R(given[1])};
        expect_equal<R>(group, is_multiprecision<R> || role == Role::ClosedForm ? few : inputs, parameters);
      });
  }
}

TEST(joint, green_coordinates) {
  expect_equal_in_all_scalars({"triangle.double_layer", "triangle.single_layer"}, triangle_inputs(64), 8);
}
TEST(joint, biharmonic_coordinates) {
  expect_equal_in_all_scalars({"triangle.double_layer", "triangle.single_layer", "triangle.biharmonic_double_layer",
                               "triangle.biharmonic_single_layer"},
                              triangle_inputs(48), 4);
}
TEST(joint, somigliana_coordinates) {
  expect_equal_in_all_scalars({"triangle.kelvin_traction", "triangle.kelvin_displacement"}, triangle_inputs(32), 4);
}
TEST(joint, all_formulas_on_a_triangle) {
  expect_equal_in_all_scalars(
      {"triangle.mean_value", "triangle.kelvin_traction", "triangle.solid_angle", "triangle.affine_single_layer",
       "triangle.double_layer", "triangle.kelvin_displacement", "triangle.biharmonic_single_layer",
       "triangle.single_layer", "triangle.biharmonic_double_layer"},
      triangle_inputs(16), 2);
}
TEST(joint, all_formulas_on_a_segment) {
  expect_equal_in_all_scalars(
      {"segment.mean_value", "segment.kelvin_traction", "segment.winding_angle", "segment.biharmonic_double_layer",
       "segment.affine_single_layer", "segment.kelvin_displacement", "segment.double_layer",
       "segment.biharmonic_single_layer", "segment.single_layer"},
      segment_inputs(16), 2);
}
TEST(joint, polyharmonic_layers) {
  for (const double order : {1., 2., 3., 6.})
    expect_equal_in_all_scalars({"segment.polyharmonic_single_layer", "segment.polyharmonic_double_layer"},
                                segment_inputs(16), 2, {order, 0});
}
TEST(joint, green_coordinates_of_polygons) {
  expect_equal_in_all_scalars({"segment.double_layer", "segment.single_layer"}, segment_inputs(40), 20);
}

}  // namespace
}  // namespace cageproof::closed_form::joint_test
