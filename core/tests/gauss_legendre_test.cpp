// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"

#include <gtest/gtest.h>

namespace cageproof {
namespace {

constexpr int kSizes[] = {1, 2, 3, 4, 7, 16, 33, 60};

template <class R>
class gauss_legendre_rule : public testing::Test {
 protected:
  // Rounding of n terms, each a few units.
  static R tolerance(int n) { return unit_roundoff<R>() * R(16 + 4 * n); }
};
using Scalars = testing::Types<float, double, Mp50, Mp100>;
TYPED_TEST_SUITE(gauss_legendre_rule, Scalars);

TYPED_TEST(gauss_legendre_rule, is_exact_for_polynomials_up_to_its_degree) {
  using R = TypeParam;
  using std::abs;
  for (const int n : kSizes) {
    const auto& rule = gauss_legendre<R>(n);
    std::vector<R> powers(n, R(1));
    for (int degree = 0; degree < 2 * n; ++degree) {
      R sum = 0;
      for (int k = 0; k < n; ++k) {
        sum += rule.weights[k] * powers[k];
        powers[k] *= rule.nodes[k];
      }
      const R error = abs(sum * R(degree + 1) - 1);
      ASSERT_LE(error, this->tolerance(n + degree)) << n << " points, degree " << degree;
    }
  }
}

TYPED_TEST(gauss_legendre_rule, is_not_exact_beyond) {
  using R = TypeParam;
  using std::abs;
  for (const int n : {1, 2, 3}) {
    const auto& rule = gauss_legendre<R>(n);
    R sum = 0;
    for (int k = 0; k < n; ++k) {
      R power = 1;
      for (int i = 0; i < 2 * n; ++i) power *= rule.nodes[k];
      sum += rule.weights[k] * power;
    }
    EXPECT_GT(abs(sum * R(2 * n + 1) - 1), R(1) / 1000) << n;
  }
}

TYPED_TEST(gauss_legendre_rule, has_positive_weights_of_sum_one) {
  using R = TypeParam;
  using std::abs;
  for (const int n : kSizes) {
    R sum = 0;
    for (const R& w : gauss_legendre<R>(n).weights) {
      ASSERT_GT(w, 0);
      sum += w;
    }
    EXPECT_LE(abs(sum - 1), this->tolerance(n)) << n;
  }
}

TYPED_TEST(gauss_legendre_rule, is_symmetric_and_rises) {
  using R = TypeParam;
  using std::abs;
  for (const int n : kSizes) {
    const auto& rule = gauss_legendre<R>(n);
    ASSERT_EQ(rule.nodes.size(), n);
    ASSERT_EQ(rule.weights.size(), n);
    for (int k = 0; k < n; ++k) {
      EXPECT_EQ(rule.weights[k], rule.weights[n - 1 - k]);
      EXPECT_LE(abs(rule.nodes[k] + rule.nodes[n - 1 - k] - 1), 2 * unit_roundoff<R>());
      EXPECT_GT(rule.nodes[k], k == 0 ? R(0) : rule.nodes[k - 1]);
      EXPECT_LT(rule.nodes[k], R(1));
    }
  }
}

TYPED_TEST(gauss_legendre_rule, two_points_are_the_known_ones) {
  using R = TypeParam;
  using std::abs, std::sqrt;
  const R expected = (1 - 1 / sqrt(R(3))) / 2;
  EXPECT_LE(abs(gauss_legendre<R>(2).nodes[0] - expected), 2 * unit_roundoff<R>());
  EXPECT_EQ(&gauss_legendre<R>(2), &gauss_legendre<R>(2)) << "computed once";
}

TEST(gauss_legendre_double, is_the_rounding_of_fifty_digits) {
  for (const int n : {5, 200}) {
    const auto& wide = gauss_legendre<Mp50>(n);
    const auto& narrow = gauss_legendre<double>(n);
    for (int k = 0; k < n; ++k) {
      EXPECT_EQ(narrow.nodes[k], static_cast<double>(wide.nodes[k]));
      EXPECT_EQ(narrow.weights[k], static_cast<double>(wide.weights[k]));
    }
  }
}

}  // namespace
}  // namespace cageproof
