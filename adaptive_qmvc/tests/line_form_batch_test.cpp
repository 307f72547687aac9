// SPDX-License-Identifier: MIT
// The line form's statements and costs as an evaluation: by any of its names, in float, in batches.
#include "quads.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace {

// Counts what this program's threads allocate.
thread_local std::size_t allocations = 0;

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace cageproof::adaptive_qmvc::line_form_batch_test {
namespace {

Evaluation evaluation(const char* name) { return evaluation_named("quad.mean_value", name); }

TEST(line_form, is_recommended_and_has_closed_form_for_another_name) {
  EXPECT_EQ(evaluation("closed_form").name(), "line_form");
  EXPECT_EQ(evaluation("line_form").role(), Role::Recommended);
  EXPECT_EQ(EvaluationRegister::instance().with_role("quad.mean_value", Role::Recommended)->name(), "line_form");
  const auto standard = EvaluationRegister::instance().standard("quad.mean_value");
  EXPECT_EQ(standard.front(), "line_form");
  EXPECT_EQ(std::ranges::count(standard, "closed_form"), 0);
}

// The quad is folded on itself, and the point is 5e-27 off a double point: rules that do not separate two singularities
// next to the interval miss their digits.
TEST(line_form, converges_in_float_too_next_to_a_crossing) {
  const Quad<double> folded{Vec3<double>(-1, -1, 0), Vec3<double>(1, 1, -1), Vec3<double>(0, -1, 0),
                            Vec3<double>(0, 0, 0)};
  const Vec3<double> eta(0x1.8p-88, -0.25, -0.25);
  Result<double> plain;
  evaluation("line_form")(Query<double>{folded, eta}, plain);
  ASSERT_TRUE(plain.converged);
  Result<float> single;
  evaluation("line_form")(Query<float>{convert_quad<float>(folded), convert<float>(eta)}, single);
  EXPECT_TRUE(single.converged);
  EXPECT_EQ(single.nodes, plain.nodes);
}

// Points next to the quad, far from it and on it.
std::vector<Vec3<double>> points_about(const Quad<double>& q) {
  std::vector<Vec3<double>> points{combined(q, basis_at(.25, .5)), q[2]};
  for (int i = 0; i < 60; ++i) {
    RandomStream random(3, "batch", i);
    const double u = random.uniform(-.5, 1.5), v = random.uniform(-.5, 1.5);
    points.push_back(combined(q, basis_at(u, v)) + std::pow(10, random.uniform(-12, 2)) * normal_at(q, u, v));
  }
  return points;
}

template <Scalar R>
void expect_batches_of_single_points(const char* name, int order) {
  const Quad<R> q = convert_quad<R>(lifted_square(.5));
  std::vector<Vec3<R>> points;
  for (const Vec3<double>& p : points_about(lifted_square(.5))) points.push_back(convert<R>(p));
  const Evaluation weights = evaluation(name);
  std::array<std::vector<R>, 3> tensors;
  BatchOutput<R> output;
  for (int o = 0; o <= order; ++o) {
    output.stride[o] = 4 * derivative_count(3, o);
    tensors[o].assign(points.size() * output.stride[o], R(0));
    output.tensors[o] = tensors[o].data();
  }
  std::vector<Statement> statements(points.size());
  output.statements = statements.data();
  weights(Batch<R>{q, points, order}, output);
  Result<R> one;
  for (std::size_t p = 0; p < points.size(); ++p) {
    weights(Query<R>{q, points[p], order}, one);
    EXPECT_EQ(one.nodes, statements[p].nodes);
    for (int o = 0; o <= order; ++o)
      for (std::size_t i = 0; i < one.of(o).size(); ++i) {
        const R& found = tensors[o][p * output.stride[o] + i];
        EXPECT_TRUE(found == one.of(o)[i] || (found != found && one.of(o)[i] != one.of(o)[i]))
            << name << ' ' << p << ' ' << o;
      }
  }
}

TEST(batches, are_single_points_one_after_the_other) {
  expect_batches_of_single_points<double>("line_form", 2);
  expect_batches_of_single_points<float>("line_form", 2);
  expect_batches_of_single_points<double>("riemann-4", 0);
  expect_batches_of_single_points<Mp50>("riemann-2", 0);
  expect_batches_of_single_points<double>("tessellated-3", 0);
}

// The first batch fills tables of rules that each thread keeps.
TEST(batches, of_the_line_form_and_the_scheme_allocate_nothing) {
  const Quad<double> q = lifted_square(.5);
  const std::vector<Vec3<double>> points = points_about(q);
  std::vector<double> value(4 * points.size()), gradient(12 * points.size()), hessian(36 * points.size());
  const BatchOutput<double> output{.tensors = {value.data(), gradient.data(), hessian.data()}, .stride = {4, 12, 36}};
  for (const auto& [name, order] : {std::pair{"line_form", 0}, {"line_form", 2}, {"line-12", 1}, {"riemann-4", 0}}) {
    const Evaluation weights = evaluation(name);
    // On the quad the exact decision takes rational numbers; off it nothing does.
    const Batch<double> off_quad{q, std::span(points).subspan(2), order};
    weights(off_quad, output);
    const std::size_t before = allocations;
    weights(off_quad, output);
    EXPECT_EQ(allocations - before, 0u) << name << " order " << order;
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::line_form_batch_test
