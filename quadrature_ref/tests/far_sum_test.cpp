// SPDX-License-Identifier: MIT
// The sum far from a triangle, of which multiprecision evaluations compare two: with fewer digits than it was asked for
// the comparison would cost attempts, and might find two that are wrong alike.
#include "../src/rules/triangle/triangle_sums.h"

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/quadrature_ref/scalar_kernel.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

struct Flux {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-Dim, Order>(node, scale, jet);
  }
};

TEST(FarSum, has_the_digits_that_it_is_asked_for) {
  const auto kernels = scalar_kernels<Flux, 2, 3>();
  const Integrand integrand{*find_formula("triangle.double_layer"), *kernels, 0};
  for (int i = 0; i < 6; ++i) {
    RandomStream random(3, "far sums", i);
    const auto near_to = [&](double x, double y) {
      return cageproof::convert<Mp200>(
          Vec3<double>(x + random.uniform(-.2, .2), y + random.uniform(-.2, .2), random.uniform(-.2, .2)));
    };
    const std::array<Vec3<Mp200>, 3> corners{near_to(0, 0), near_to(1, 0), near_to(0, 1)};
    const double distance = i % 2 == 0 ? 2.5 : 10;
    const Vec3<double> way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec3<Mp200> point = cageproof::convert<Mp200>(Vec3<double>(distance * way.normalized()));
    const Query<Mp200> query{corners, point, 2};
    const auto triangle = lined_triangle(corners, point);
    ASSERT_TRUE(triangle);
    FarSum sum(integrand, *triangle, query);
    const Result<Mp200> truth = sum.at(100);
    for (const double digits : {20., 34., 60.}) {
      const Result<Mp200> found = sum.at(digits);
      for (int o = 0; o <= 2; ++o) EXPECT_GE(agreement(found.of(o), truth.of(o), 200), digits) << i << ", order " << o;
    }
  }
}

// Far away one rule serves many digits: two sums that used it would agree, whatever was wrong.
TEST(FarSum, compared_sums_have_other_rules) {
  const auto kernels = scalar_kernels<Flux, 2, 3>();
  const Integrand integrand{*find_formula("triangle.double_layer"), *kernels, 0};
  for (const double distance : {10., 1e4, 1e12}) {
    const std::array<Vec3<Mp200>, 3> corners{cageproof::convert<Mp200>(Vec3<double>(0, 0, 0)),
                                             cageproof::convert<Mp200>(Vec3<double>(1, 0, 0)),
                                             cageproof::convert<Mp200>(Vec3<double>(0, 1, 0))};
    const Vec3<Mp200> point = cageproof::convert<Mp200>(Vec3<double>(distance, distance / 2, distance / 4));
    const Query<Mp200> query{corners, point, 0};
    const auto triangle = lined_triangle(corners, point);
    ASSERT_TRUE(triangle);
    FarSum sum(integrand, *triangle, query);
    sum.at(31);
    const std::size_t first = sum.nodes();
    sum.at(31);
    EXPECT_NE(sum.nodes(), 2 * first) << distance;
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
