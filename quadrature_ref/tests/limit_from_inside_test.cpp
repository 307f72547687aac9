// SPDX-License-Identifier: MIT
// The limit on an element, from sums whose limit is known: power series of the distance, with and without logarithms.
#include "../src/rules/converging_sum.h"

#include <gtest/gtest.h>

namespace cageproof::quadrature_ref {
namespace {

using Function = std::function<Mp200(const Mp200& inward)>;

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
  static const KernelSet none;
  const Integrand integrand{*find_formula("triangle.solid_angle"), none};
  const Query<Mp200> query{};
  const Inside inside{
      .moved = [&](const Mp200& inward) { return std::make_unique<Exact>(integrand, query, f(inward)); },
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

}  // namespace
}  // namespace cageproof::quadrature_ref
