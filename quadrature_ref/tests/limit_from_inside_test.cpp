// SPDX-License-Identifier: MIT
// The limit on an element, from sums whose limit is known: power series of the distance, with and without logarithms.
#include "../src/rules/converging_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace cageproof::quadrature_ref {
namespace {

using Function = std::function<Mp200(const Mp200& inward)>;

const Integrand& solid_angle() {
  static const KernelSet none;
  static const Integrand integrand{*find_formula("triangle.solid_angle"), none, 0};
  return integrand;
}

// A number that depends on the distance, as a sum that has it exactly.
class Exact final : public ConvergingSum {
 public:
  Exact(const Integrand& integrand, const Query<Mp200>& query, const Mp200& value)
      : ConvergingSum(integrand, query), value_(value) {}
  Result<Mp200> at(double) override {
    Result<Mp200> result = empty();
    result.value[0] = value_;
    return result;
  }

 private:
  Mp200 value_;
};

Answer limit(const Function& f, bool border, double digits) {
  const Query<Mp200> query{};
  const Inside inside{
      .moved = [&](const Mp200& inward) { return std::make_unique<Exact>(solid_angle(), query, f(inward)); },
      .clearance = Mp200(0.25),
      .border = border};
  return limit_from_inside(inside, digits, 0);
}

const Function kSeries = [](const Mp200& h) { return Mp200(3 + h * (5 + h * (-7 + h * (11 + h * 13)))); };
const Function kWithLogarithms = [](const Mp200& h) { return Mp200(kSeries(h) + h * log(h) * (2 + h * (3 - 4 * h))); };

TEST(LimitFromInside, power_series_inside_and_with_logarithms_on_the_border) {
  for (const double digits : {30.0, 60.0}) {
    for (const auto& [f, border] : {std::pair{kSeries, false}, {kSeries, true}, {kWithLogarithms, true}}) {
      const Answer answer = limit(f, border, digits);
      EXPECT_GE(answer.digits[0], digits);
      EXPECT_LT(abs(answer.sums.value[0] - 3), pow(Mp200(10), Mp200(-answer.digits[0])));
    }
  }
}

// The statement is measured, not assumed: a logarithm in the last term costs digits, and it says how many.
TEST(LimitFromInside, states_the_digits_that_are_there) {
  const Function f = [](const Mp200& h) { return Mp200(3 + 1e6 * h * h * log(h)); };
  const Answer answer = limit(f, false, 30);
  EXPECT_GT(answer.digits[0], 20);
  EXPECT_LT(answer.digits[0], 30);
  EXPECT_LT(abs(answer.sums.value[0] - 3), pow(Mp200(10), Mp200(-answer.digits[0])));
}

TEST(LimitFromInside, what_is_not_a_number_has_none) {
  const Answer answer = limit([](const Mp200&) { return std::numeric_limits<Mp200>::quiet_NaN(); }, false, 30);
  EXPECT_TRUE(std::isnan(answer.digits[0]));
}

TEST(LimitFromInside, what_diverges_has_none) {
  for (const bool border : {false, true})
    for (const Function& f :
         {Function([](const Mp200& h) { return log(h); }), Function([](const Mp200& h) { return Mp200(1 / h); }),
          Function([](const Mp200& h) { return Mp200(3 + 1 / (h * h)); }),
          Function([](const Mp200& h) { return Mp200(1e6 + log(h)); })}) {
      const Answer answer = limit(f, border, 30);
      EXPECT_TRUE(isnan(answer.sums.value[0])) << answer.sums.value[0];
      EXPECT_TRUE(std::isnan(answer.digits[0]));
    }
}

TEST(LimitFromInside, a_limit_of_zero_is_exactly_zero) {
  const Answer answer = limit([](const Mp200& h) { return Mp200(h * (2 - h)); }, false, 30);
  EXPECT_EQ(answer.sums.value[0], 0);
  EXPECT_GE(answer.digits[0], 30);
}

// All entries of all orders are 3, but one order may be declined.
class Declining final : public ConvergingSum {
 public:
  Declining(const Query<Mp200>& query, std::optional<int> declined)
      : ConvergingSum(solid_angle(), query), declined_(declined) {}
  Result<Mp200> at(double) override {
    std::array<double, 3> norms{};
    if (declined_) norms[*declined_] = std::numeric_limits<double>::infinity();
    take_log10_norms(norms);
    Result<Mp200> result = empty();
    for (int o = 0; o <= order_; ++o) std::ranges::fill(result.of(o), Mp200(3));
    return result;
  }

 private:
  std::optional<int> declined_;
};

TEST(LimitFromInside, an_order_that_one_distance_declines_has_none_and_the_others_have_theirs) {
  const Query<Mp200> query{{}, Vec3<Mp200>::Zero(), 2};
  for (int declined = 0; declined <= 2; ++declined) {
    int sums = 0;
    const Inside inside{.moved =
                            [&](const Mp200&) {
                              ++sums;
                              return std::make_unique<Declining>(query,
                                                                 sums == 2 ? std::optional(declined) : std::nullopt);
                            },
                        .clearance = Mp200(0.25)};
    const Answer answer = limit_from_inside(inside, 30, 2);
    EXPECT_GT(sums, 2);
    for (int o = 0; o <= 2; ++o)
      for (const Mp200& entry : answer.sums.of(o)) {
        if (o == declined) {
          EXPECT_TRUE(isnan(entry)) << o;
        } else {
          EXPECT_EQ(entry, 3) << o << " beside " << declined;
        }
      }
    EXPECT_EQ(answer.digits[declined], 0);
  }
}

// Entries of given sizes, log10, of which sums that err by more see nothing.
class Sized final : public ConvergingSum {
 public:
  Sized(const Query<Mp200>& query, const std::array<double, 3>& log10_size)
      : ConvergingSum(solid_angle(), query), log10_size_(log10_size) {}
  Result<Mp200> at(double) override {
    find_log10_norms({0, 0, 0}, [&](const std::array<double, 3>& log10_error) {
      Result<Mp200> result = empty();
      for (int o = 0; o <= order_; ++o)
        if (log10_error[o] < log10_size_[o]) result.of(o)[0] = pow(Mp200(10), Mp200(log10_size_[o]));
      return result;
    });
    return empty();
  }

 private:
  std::array<double, 3> log10_size_;
};

TEST(ConvergingSum, finds_each_orders_norm_however_much_cancels) {
  const Query<Mp200> query{{}, Vec3<Mp200>::Zero(), 2};
  for (const auto& sizes : {std::array{0., -30., -60.}, {-60., 0., -30.}, {-5., -80., 0.}, {-150., -1., -20.}}) {
    Sized sum(query, sizes);
    sum.at(30);
    for (int o = 0; o <= 2; ++o) EXPECT_NEAR(sum.log10_norms()[o], sizes[o], 1e-9) << o;
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
