// SPDX-License-Identifier: MIT
#include "cageproof/core/results/error_measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cageproof::error_measure_test {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

bool same(const ErrorHistogram& a, const ErrorHistogram& b) {
  return a.counts() == b.counts() && a.count() == b.count() && a.nonfinite() == b.nonfinite() && a.max() == b.max();
}

WorstCase worst_case(double error, std::uint64_t sample) {
  WorstCase c;
  c.error = error;
  c.sample = sample;
  return c;
}

std::vector<std::pair<double, std::uint64_t>> keys(const WorstCases& worst) {
  std::vector<std::pair<double, std::uint64_t>> result;
  for (const WorstCase& c : worst.cases()) result.emplace_back(c.error, c.sample);
  return result;
}

TEST(error_histogram, empty_one_says_zero) {
  const ErrorHistogram h;
  EXPECT_EQ(h.count(), 0u);
  EXPECT_EQ(h.max(), 0);
  EXPECT_EQ(h.median(), 0);
}

TEST(error_histogram, counts_every_error_once_in_its_bin) {
  ErrorHistogram h;
  // Zero and below, the first bin, the middle of the decade from 1, the last bin, above, infinite.
  for (const double error : {0.0, 9e-7, 1.1e-6, 3.0, 0.95e24, 2e24, kInfinity}) h.add(error);
  const auto counts = h.counts();
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}), 7u);
  EXPECT_EQ(counts.front(), 2u);
  EXPECT_EQ(counts[1], 1u);
  EXPECT_EQ(counts[1 + 60 + 4], 1u) << "3 lies between 10^0.4 and 10^0.5";
  EXPECT_EQ(counts[ErrorHistogram::bin_count], 1u);
  EXPECT_EQ(counts.back(), 2u);
  EXPECT_EQ(h.count(), 7u);
}

TEST(error_histogram, maximum_is_exact) {
  ErrorHistogram h;
  h.add(0.1);
  h.add(3.0000000000000004);
  h.add(3);
  EXPECT_EQ(h.max(), 3.0000000000000004);
}

TEST(error_histogram, nan_counts_as_infinite) {
  ErrorHistogram h;
  h.add(std::nan(""));
  h.add(kInfinity);
  EXPECT_EQ(h.nonfinite(), 2u);
  EXPECT_EQ(h.max(), kInfinity);
  EXPECT_EQ(h.median(), kInfinity);
}

TEST(error_histogram, quantile_is_within_a_bin_above_the_true_one) {
  ErrorHistogram h;
  std::vector<double> errors;
  errors.reserve(10000);
  for (int i = 0; i < 10000; ++i) errors.push_back(std::exp(std::fmod(i * 0.7310585, 1.0) * 12 - 6));
  for (const double error : errors) h.add(error);
  std::ranges::sort(errors);
  for (const double q : {0.001, 0.25, 0.5, 0.9, 0.999, 1.0}) {
    const double truth = errors[static_cast<std::size_t>(std::ceil(q * 10000)) - 1];
    EXPECT_GE(h.quantile(q), truth) << q;
    EXPECT_LE(h.quantile(q), truth * std::pow(10, 0.1) * (1 + 1e-12)) << q;
  }
  EXPECT_EQ(h.quantile(1), h.max());
  EXPECT_EQ(h.p999(), h.quantile(0.999));
}

TEST(error_histogram, merging_is_the_same_as_adding_in_any_order) {
  std::vector<double> errors{0, 1e-9, 0.3, 2, 2, 77, 1e30, kInfinity};
  ErrorHistogram all, left, right;
  for (const double error : errors) all.add(error);
  for (std::size_t i = 0; i < errors.size(); ++i) (i % 3 == 0 ? left : right).add(errors[i]);
  ErrorHistogram a = left, b = right;
  a.merge(right);
  b.merge(left);
  EXPECT_TRUE(same(a, all));
  EXPECT_TRUE(same(b, all));
  a.merge(ErrorHistogram{});
  EXPECT_TRUE(same(a, all));
}

TEST(worst_cases, do_not_depend_on_the_order) {
  std::vector<std::pair<double, std::uint64_t>> input{{1, 9}, {5, 1}, {5, 0}, {kInfinity, 7}, {2, 3}, {0, 2}};
  const std::vector<std::pair<double, std::uint64_t>> expected{{kInfinity, 7}, {5, 0}, {5, 1}};
  std::ranges::sort(input);
  do {
    WorstCases all(3), left(3), right(3);
    for (std::size_t i = 0; i < input.size(); ++i) {
      all.add(worst_case(input[i].first, input[i].second));
      (i < 3 ? left : right).add(worst_case(input[i].first, input[i].second));
    }
    right.merge(left);
    ASSERT_EQ(keys(all), expected);
    ASSERT_EQ(keys(right), expected);
  } while (std::ranges::next_permutation(input).found);
}

TEST(worst_cases, tell_frames_of_a_cage_apart) {
  WorstCase here{1, 0, 3}, scaled = here, moved = here;
  scaled.frame.unit = 2;
  moved.frame.shift[2] = -1;
  for (const WorstCase& other : {scaled, moved}) {
    WorstCases one(1), another(1);
    for (const WorstCase& c : {here, other}) one.add(c);
    for (const WorstCase& c : {other, here}) another.add(c);
    EXPECT_EQ(one.cases()[0].frame.unit, another.cases()[0].frame.unit);
    EXPECT_EQ(one.cases()[0].frame.shift, another.cases()[0].frame.shift);
  }
}

TEST(worst_cases, wants_says_what_add_does) {
  WorstCases worst(2);
  EXPECT_TRUE(worst.wants(0, 0));
  worst.add(worst_case(3, 4));
  worst.add(worst_case(3, 2));
  EXPECT_FALSE(worst.wants(2, 0));
  EXPECT_TRUE(worst.wants(3, 4));  // the input decides
  EXPECT_FALSE(worst.wants(3, 5));
  EXPECT_TRUE(worst.wants(3, 3));
  EXPECT_TRUE(worst.wants(4, 9));
  worst.add(worst_case(3, 5));
  EXPECT_EQ(keys(worst), (std::vector<std::pair<double, std::uint64_t>>{{3, 2}, {3, 4}}));
}

TEST(worst_cases, keep_the_input_exactly) {
  WorstCase c = worst_case(1, 0);
  c.corners = {{0.1, 1e-300, -0.0}};
  c.point = {1.0 / 3, 2, 3};
  c.parameters = {0.3};
  WorstCases worst;
  worst.add(c);
  EXPECT_EQ(worst.cases()[0].corners, c.corners);
  EXPECT_EQ(worst.cases()[0].point, c.point);
  EXPECT_EQ(worst.cases()[0].parameters, c.parameters);
  WorstCases none(0);
  none.add(c);
  EXPECT_TRUE(none.cases().empty());
}

}  // namespace
}  // namespace cageproof::error_measure_test
