// SPDX-License-Identifier: MIT
// Gauss nodes from their definition: rising, within the interval, and exact for polynomials.
#include "../src/rules/gauss_nodes.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

// In roundings of R: powers of nodes below one, and sums of n terms.
template <Scalar R>
void expect_exact(int n) {
  using std::abs;
  const GaussNodes<R>& rule = gauss_nodes<R>(n);
  ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
  R below = 0;
  for (const R& x : rule.nodes) {
    EXPECT_LT(below, x);
    below = x;
  }
  EXPECT_LT(below, R(1));
  std::vector<R> terms = rule.weights;
  for (int degree = 0; degree < 2 * n; ++degree) {
    R sum = 0;
    for (int i = 0; i < n; ++i) {
      sum += terms[i];
      terms[i] *= rule.nodes[i];
    }
    const double roundings = static_cast<double>(R(abs(sum * R(degree + 1) - 1) / unit_roundoff<R>()));
    EXPECT_LT(roundings, 8 + 2 * n + degree) << n << " points, degree " << degree;
  }
}

TEST(GaussNodes, integrate_polynomials_exactly) {
  for (const int n : {1, 2, 3, 5, 8, 20, 63, 64}) {
    expect_exact<float>(n);
    expect_exact<double>(n);
    expect_exact<Mp50>(n);
    expect_exact<Mp100>(n);
    expect_exact<Mp200>(n);
  }
  expect_exact<Mp100>(300);
}

TEST(GaussNodes, are_those_of_tables) {
  EXPECT_EQ(gauss_nodes<double>(1).nodes[0], 0.5);
  EXPECT_EQ(gauss_nodes<double>(3).weights[0], 5. / 18);
  EXPECT_EQ(gauss_nodes<double>(3).weights[1], 4. / 9);
  const Mp50 third = (1 - sqrt(Mp50(3)) / 3) / 2;
  EXPECT_LT(abs(gauss_nodes<Mp50>(2).nodes[0] - third), Mp50("1e-49"));
}

}  // namespace
}  // namespace cageproof::quadrature_ref
